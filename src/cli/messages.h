// What the program says: messages on stderr, answers on stdout.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "core/base/shown_text.h"

namespace triscope {

/// Writes to stderr, as it is; say() shows what others wrote as shownLines() does. What cannot be written there is
/// lost, and changes nothing that the program does.
void sayText(std::string_view text);

template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  sayText(shownLines(fmt::format(format, std::forward<Args>(args)...)));
}

/// Writes to stdout, as it is; answer() likewise. That it could not be written is found at the end, by endOfAnswers().
void answerText(std::string_view text);

template <class... Args>
void answer(fmt::format_string<Args...> format, Args&&... args) {
  answerText(shownLines(fmt::format(format, std::forward<Args>(args)...)));
}

/// Whether all answers have been written.
bool endOfAnswers();

/// Keeps the numbers of standard streams that are closed from the files that will be opened: a message would go into
/// one of them. Such a stream stays one that nothing can be written to.
void holdStandardStreams();

}  // namespace triscope

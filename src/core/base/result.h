// One way to fail: a value that says what is wrong, where, and what to do about it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/base/point.h"

namespace triscope {

/// What kind of thing went wrong: who passes an error on to a person or a script goes by it.
enum class ErrorKind : std::uint8_t {
  bad_data,      // the input was read and is wrong
  no_input,      // the input cannot be opened
  cannot_write,  // the output cannot be written
  usage,         // what was asked for makes no sense
  unmet,         // a bound is not met, a mesh is not valid, or the method cannot go on
  no_display,    // no window can be opened here
  no_memory,     // there is not enough memory
  cancelled,     // somebody wanted it to end
  internal,      // a defect of the program
};

struct Error {
  ErrorKind kind = ErrorKind::bad_data;
  std::string message{};      // what is wrong, with the numbers
  std::string hint{};         // what to do about it
  std::string file{};         // empty when it came from no file
  std::string loop{};         // name of the loop, empty when none
  int point = -1;             // index of the point within the loop as the file numbers it, -1 when none
  std::optional<Point> at{};  // place in the plane, for the window to show
};

/// What is said where std::bad_alloc is caught.
inline Error notEnoughMemory() {
  return {.kind = ErrorKind::no_memory,
          .message = "not enough memory",
          .hint =
              "a larger min_edge_length, or larger lengths in \"density\", make a smaller mesh; max_triangles stops "
              "one that would be too large before it is made"};
}

/// "file: loop 'name', point 3 at (x, y): message; hint" on one line.
std::string describe(const Error& error);

template <class T>
class Result {
 public:
  Result(T value) : value_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : value_(std::move(error)) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] bool ok() const { return std::holds_alternative<T>(value_); }
  explicit operator bool() const { return ok(); }
  T& operator*() { return std::get<T>(value_); }
  const T& operator*() const { return std::get<T>(value_); }
  T* operator->() { return &std::get<T>(value_); }
  const T* operator->() const { return &std::get<T>(value_); }
  [[nodiscard]] const Error& error() const { return std::get<Error>(value_); }

 private:
  std::variant<T, Error> value_;
};

using Status = Result<std::monostate>;
inline Status success() { return std::monostate{}; }

}  // namespace triscope

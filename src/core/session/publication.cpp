#include "core/session/publication.h"

#include <utility>

namespace triscope {

void add(Publication& waiting, Publication news) {
  const bool both = waiting.snapshot && news.snapshot;
  if (both && news.keepEvents >= waiting.keepEvents) {
    std::vector<Event> events = std::move(waiting.freshEvents);
    events.resize(static_cast<std::size_t>(news.keepEvents - waiting.keepEvents));
    events.insert(events.end(), news.freshEvents.begin(), news.freshEvents.end());
    news.freshEvents = std::move(events);
    news.keepEvents = waiting.keepEvents;
  } else if (!news.snapshot) {
    news.snapshot = std::move(waiting.snapshot);
    news.keepEvents = waiting.keepEvents;
    news.freshEvents = std::move(waiting.freshEvents);
  }
  if (!news.record) news.record = std::move(waiting.record);
  if (!news.hits) news.hits = std::move(waiting.hits);
  waiting = std::move(news);
}

}  // namespace triscope

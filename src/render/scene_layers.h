// The layers of a scene: what each depends on, and what fills it.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "core/base/digest.h"
#include "render/scene_parts.h"

namespace triscope::detail {

/// Digest of what a layer depends on; not of its content, which would cost as much as building it.
class LayerKey {
 public:
  template <class T>
  LayerKey& operator<<(T value) {
    if constexpr (std::is_same_v<T, double>)
      digest_.number(value);
    else
      digest_.word(static_cast<std::uint64_t>(value));
    return *this;
  }
  template <class Kind, class Word>
  LayerKey& operator<<(Index<Kind, Word> index) {
    return *this << index.n;
  }
  LayerKey& operator<<(const Point& p) { return *this << p.x << p.y; }
  [[nodiscard]] std::uint64_t value() const { return digest_.value | 1u; }  // 0 means never built

 private:
  Digest digest_;
};

/// What keys begin with, worked out once for all of them.
struct KeyStart {
  LayerKey run;     // domain, settings and Δx decide everything that follows; and how all layers look
  LayerKey moment;  // of the run
};
KeyStart keyStartOf(const SceneInput& in);

/// A layer is both or nothing: one that is built but has no key would show for ever what it showed first.
struct LayerPart {
  using KeyOf = LayerKey (*)(const SceneInput&, const KeyStart&);
  using Build = void (*)(const SceneInput&, Layer&);
  using Patch = bool (*)(const SceneInput&, Layer&);
  constexpr LayerPart(LayerId which, KeyOf keyOf, Build fill, Patch mend = nullptr)
      : id(which), key(keyOf), build(fill), patch(mend) {}
  LayerId id;
  KeyOf key;
  Build build;
  Patch patch;  // null: it is built anew
};

/// One entry per LayerId, in order.
const std::array<LayerPart, kLayerCount>& layerParts();

}  // namespace triscope::detail

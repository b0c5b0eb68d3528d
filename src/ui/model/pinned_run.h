// Run A, pinned beside the live run B: a session and a picture of its own, kept where B stands.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/session/session.h"
#include "core/study/compare.h"
#include "render/camera.h"
#include "render/gl_renderer.h"
#include "render/scene.h"

namespace triscope {

class PinnedRun {
 public:
  /// Meshes the domain with these settings, to the end. A context of OpenGL must be current.
  PinnedRun(std::shared_ptr<const Domain> domain, const Settings& settings, std::function<void()> wake);

  /// Whether the runs on this domain can be laid over this one.
  [[nodiscard]] bool suits(const Domain& domain) const;
  bool poll() { return session_.poll(); }
  /// Works out where the runs part when that may have changed, and goes to what stands for the live run's place.
  void follow(const Session& live);
  void draw(ViewOptions options, const Camera& camera, double density);

  [[nodiscard]] const Session& session() const { return session_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] unsigned texture() const { return texture_; }
  /// The first event that differs from the live run's, as far as that is known.
  [[nodiscard]] const std::optional<std::size_t>& firstDifference() const { return first_; }

 private:
  /// What the first difference depends on.
  struct Compared {
    std::shared_ptr<const Domain> domain;
    Settings settings;
    std::size_t events = 0;
    bool complete = false;
    friend bool operator==(const Compared&, const Compared&) = default;
  };

  Session session_;
  std::shared_ptr<const Domain> domain_;
  Scene scene_;
  GlRenderer renderer_;
  unsigned texture_ = 0;
  std::optional<Compared> compared_;
  std::optional<std::size_t> first_;
  std::optional<Counterpart> place_;  // gone to last
};

}  // namespace triscope

#include "ui/app/window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "ui/app/app.h"
#include "ui/app/key_queue.h"
#include "ui/app/screenshot.h"

namespace triscope {
namespace {

using Clock = std::chrono::steady_clock;

// Dear ImGui settles hovering, popups and sizes within this many frames of an event.
constexpr int kFramesAfterEvent = 3;
// While a run goes on: how long to sleep when nothing is published.
constexpr double kRunningWait = 0.05;
constexpr double kCaretWait = 0.25;

struct LoopState {
  App* app = nullptr;
  int framesWanted = kFramesAfterEvent;
  KeyQueue keys;
};

LoopState& stateOf(GLFWwindow* window) { return *static_cast<LoopState*>(glfwGetWindowUserPointer(window)); }

void stir(GLFWwindow* window) { stateOf(window).framesWanted = kFramesAfterEvent; }

// Our callbacks are installed before Dear ImGui's, which call them in turn.
void installCallbacks(GLFWwindow* window) {
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    stir(w);
    if (count > 0) stateOf(w).app->onDrop(paths[0]);
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { stir(w); });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { stir(w); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { stir(w); });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { stir(w); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { stir(w); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { stir(w); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { stir(w); });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float scale, float) {
    stir(w);
    stateOf(w).app->setMonitorScale(std::clamp(static_cast<double>(scale), 0.75, 3.0));
  });
}

// After Dear ImGui's, which are called when the keys' turn has come.
void installKeyCallbacks(GLFWwindow* window) {
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    stir(w);
    stateOf(w).keys.push({key, scancode, action, mods, 0});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned text) {
    stir(w);
    stateOf(w).keys.push({.text = text});
  });
}

/// Hands on what this frame can act on; the rest waits for the next one.
void deliverKeys(GLFWwindow* window, LoopState& loop) {
  if (!loop.app->takesKeys()) return;
  for (const KeyEvent& event : loop.keys.take()) {
    if (event.text != 0) {
      ImGui_ImplGlfw_CharCallback(window, event.text);
      continue;
    }
    if (event.action != GLFW_RELEASE) loop.app->onKey(event.key, event.mods);
    ImGui_ImplGlfw_KeyCallback(window, event.key, event.scancode, event.action, event.mods);
  }
}

Error noDisplay(std::string message, std::string hint = {}) {
  return {.kind = ErrorKind::no_display, .message = std::move(message), .hint = std::move(hint)};
}

struct GlfwLibrary {
  bool ready = glfwInit() == GLFW_TRUE;
  ~GlfwLibrary() {
    if (ready) glfwTerminate();
  }
};

/// Only now is it known by how much the monitor's scale has enlarged the window.
void fitIntoWorkArea(GLFWwindow* window) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return;
  int x = 0, y = 0, areaWidth = 0, areaHeight = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &areaWidth, &areaHeight);
  int width = 0, height = 0;
  glfwGetWindowSize(window, &width, &height);
  if (areaWidth <= 0 || areaHeight <= 0 || (width <= areaWidth && height <= areaHeight)) return;
  glfwSetWindowSize(window, std::min(width, areaWidth), std::min(height, areaHeight));
  glfwSetWindowPos(window, x, y);
}

GLFWwindow* makeWindow() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "triscope");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "triscope");
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* const window = glfwCreateWindow(1440, 900, "Triscope", nullptr, nullptr);
  if (window == nullptr) return nullptr;
  fitIntoWorkArea(window);
  glfwSetWindowSizeLimits(window, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwShowWindow(window);
  return window;
}

/// Sleeps until something happens; a running method and a blinking caret make things happen by themselves.
void waitForWork(const LoopState& loop) {
  if (loop.framesWanted > 0 || loop.app->opensDialog())
    glfwPollEvents();
  else if (loop.app->animating())
    glfwWaitEventsTimeout(kRunningWait);
  else if (ImGui::GetIO().WantTextInput)
    glfwWaitEventsTimeout(kCaretWait);
  else if (const std::optional<double> due = loop.app->due())
    glfwWaitEventsTimeout(std::max(*due, 0.01));
  else
    glfwWaitEvents();
}

/// `screenshot`: where to write the frame; empty for nowhere.
Status drawFrame(GLFWwindow* window, App& app, const std::string& screenshot) {
  const auto start = Clock::now();
  if (app.prepareFrame()) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  app.frame();
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  const Color bare = app.surface();
  glClearColor(static_cast<float>(bare.r) / 255.0f, static_cast<float>(bare.g) / 255.0f,
               static_cast<float>(bare.b) / 255.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  Status saved = screenshot.empty() ? success() : saveScreenshot(window, screenshot);
  glfwSwapBuffers(window);
  app.finishFrame(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  return saved;
}

Status runLoop(GLFWwindow* window, App& app, LoopState& loop, const WindowOptions& options) {
  int framesSettled = 0;
  std::string title;
  while (glfwWindowShouldClose(window) == GLFW_FALSE && !app.closing()) {
    waitForWork(loop);
    if (app.poll()) loop.framesWanted = std::max(loop.framesWanted, 1);
    if (app.animating() || app.opensDialog()) loop.framesWanted = std::max(loop.framesWanted, 1);
    if (ImGui::GetIO().WantTextInput) loop.framesWanted = std::max(loop.framesWanted, 1);
    if (!options.screenshot.empty()) loop.framesWanted = kFramesAfterEvent;
    if (std::string now = app.title(); now != title) {
      title = std::move(now);
      glfwSetWindowTitle(window, title.c_str());
    }
    if (loop.framesWanted <= 0) continue;
    deliverKeys(window, loop);
    loop.framesWanted = loop.keys.empty() ? loop.framesWanted - 1 : kFramesAfterEvent;
    const bool last = !options.screenshot.empty() && app.settled() && ++framesSettled == 2 * kFramesAfterEvent;
    const Status saved = drawFrame(window, app, last ? options.screenshot : std::string());
    if (!saved) return saved.error();
    if (last) break;
  }
  return success();
}

}  // namespace

Status runWindow(const WindowOptions& options) {
  glfwSetErrorCallback([](int, const char*) {});  // what matters is asked for below
  const GlfwLibrary library;
  if (!library.ready)
    return noDisplay("no display can be opened", "use the subcommands without one ('triscope --help')");
  LoopState loop;
  App app(options, [] { glfwPostEmptyEvent(); });
  loop.app = &app;
  const std::unique_ptr<GLFWwindow, decltype(&glfwDestroyWindow)> window(makeWindow(), &glfwDestroyWindow);
  if (!window) return noDisplay("no window with OpenGL 3.3 can be opened", "is a graphics driver installed?");
  glfwMakeContextCurrent(window.get());
  if (gladLoadGL(glfwGetProcAddress) == 0) return noDisplay("OpenGL 3.3 cannot be loaded");
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window.get(), &loop);

  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // nothing is dropped into the working directory
  installCallbacks(window.get());
  ImGui_ImplGlfw_InitForOpenGL(window.get(), true);
  installKeyCallbacks(window.get());
  ImGui_ImplOpenGL3_Init("#version 330 core");
  float scale = 1.0f;
  glfwGetWindowContentScale(window.get(), &scale, nullptr);
  Status end = success();
  if (const std::string complaint = app.start(std::clamp(static_cast<double>(scale), 0.75, 3.0)); !complaint.empty())
    end = Error{.kind = ErrorKind::internal, .message = "a shader does not compile: " + complaint};
  else
    end = runLoop(window.get(), app, loop, options);
  app.releaseGl();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  return end;
}

}  // namespace triscope

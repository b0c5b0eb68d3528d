#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>

#include "core/domain/read.h"
#include "render/embedded.h"
#include "ui/dialog/dialogs.h"
#include "ui/kit/widgets.h"

namespace triscope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTitle = "Open a domain or a session";

bool canBeOpened(const fs::path& path) { return path.extension() == ".json" || path.extension() == ".session"; }

void openSample(const std::string& name, Orders& orders) {
  const auto bytes = findEmbedded(embeddedSamples(), name + ".json");
  const std::string text(bytes.begin(), bytes.end());
  if (Result<Domain> domain = parseDomain(text, ""); domain)
    orders.emplace_back(command::OpenDomain{std::make_shared<const Domain>(std::move(*domain))});
}

}  // namespace

std::vector<std::string> sampleNames() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embeddedSamples()) names.emplace_back(file.name.substr(0, file.name.rfind('.')));
  std::sort(names.begin(), names.end());
  return names;
}

void OpenDialog::prepare(const std::string& path) {
  path_ = path;
  std::error_code failure;
  const fs::path folder = path.empty() ? fs::current_path(failure) : fs::path(path).parent_path();
  list(folder.empty() ? "." : folder.string());
}

void OpenDialog::list(const std::string& folder) {
  entries_.clear();
  complaint_.clear();
  std::error_code failure;
  const fs::path whole = fs::weakly_canonical(folder, failure);
  folder_ = failure ? folder : whole.string();
  fs::directory_iterator at(folder_, fs::directory_options::skip_permission_denied, failure);
  if (failure) {
    complaint_ = "This folder cannot be listed: " + failure.message() + ".";
    return;
  }
  for (; at != fs::directory_iterator(); at.increment(failure)) {
    if (failure) break;
    const std::string name = at->path().filename().string();
    if (name.empty() || name[0] == '.') continue;
    const bool isFolder = at->is_directory(failure);
    if (isFolder || canBeOpened(at->path())) entries_.push_back({name, isFolder});
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
}

void OpenDialog::draw(const View& view, Orders& orders) {
  if (!beginDialog(view, kTitle, 620)) return;
  const ImGuiStyle& style = ImGui::GetStyle();
  // Beside the lists: what stands over them, and two rows below.
  const float others = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetFrameHeight() + 3.0f * style.ItemSpacing.y;
  const float height = std::clamp(dialogRoom(view) - others, view.px(40), view.px(260));
  std::string wanted;  // folder to go to

  ImGui::BeginGroup();
  muted(view, "Samples");
  note(view, "open.samples");
  if (ImGui::BeginChild("samples", {view.px(180), height}, true))
    for (const std::string& name : sampleNames()) {
      if (ImGui::Selectable(name.c_str())) {
        orders.emplace_back(order::CloseDialog{});
        openSample(name, orders);
      }
      note(view, "sample." + name);
    }
  ImGui::EndChild();
  ImGui::EndGroup();
  ImGui::SameLine();
  ImGui::BeginGroup();
  muted(view, folder_);
  if (ImGui::BeginChild("files", {0.0f, height}, true)) {
    if (ImGui::Selectable("..")) wanted = fs::path(folder_).parent_path().string();
    note(view, "file...");
    for (const Entry& entry : entries_) {
      const std::string whole = (fs::path(folder_) / entry.name).string();
      const std::string shown = entry.folder ? entry.name + "/" : entry.name;
      if (ImGui::Selectable(shown.c_str(), path_ == whole, ImGuiSelectableFlags_AllowDoubleClick)) {
        if (entry.folder)
          wanted = whole;
        else
          path_ = whole;
        if (!entry.folder && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
          orders.emplace_back(order::CloseDialog{});
          orders.emplace_back(command::OpenFile{whole});
        }
      }
      note(view, "file." + entry.name);
    }
    if (!complaint_.empty()) muted(view, complaint_);
  }
  ImGui::EndChild();
  ImGui::EndGroup();

  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputTextWithHint("##path", "path of a domain or session file", &path_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  note(view, "open.path");
  ImGui::BeginDisabled(path_.empty());
  const bool pressed = ImGui::Button("Open", {view.px(110), 0.0f});
  ImGui::EndDisabled();
  note(view, "open.ok", !path_.empty());
  tip(view, path_.empty() ? "Choose a file or type its path first." : "Reads, checks and meshes the file.");
  if ((pressed || entered) && !path_.empty()) {
    orders.emplace_back(order::CloseDialog{});
    orders.emplace_back(command::OpenFile{path_});
  }
  ImGui::SameLine();
  if (ImGui::Button("Close", {view.px(110), 0.0f})) orders.emplace_back(order::CloseDialog{});
  note(view, "open.close");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("or drop a file on the window");
  ImGui::EndPopup();
  if (!wanted.empty()) list(wanted);
}

}  // namespace triscope

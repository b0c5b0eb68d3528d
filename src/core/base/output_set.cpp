#include "core/base/output_set.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "core/base/stop.h"

namespace triscope {
namespace {

/// The new names are on the disk. Files are in their places already: a folder that cannot be flushed is no error.
void flushFolder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

Result<AtomicFile*> OutputSet::open(const std::string& path) {
  for (Output& output : outputs_)
    if (output.path == path) return &output.file;
  Result<AtomicFile> file = AtomicFile::create(path, flush_);
  if (!file) return file.error();
  outputs_.push_back({path, std::move(*file)});
  return &outputs_.back().file;
}

Status OutputSet::write(const std::string& path, std::string_view bytes) {
  const Result<AtomicFile*> file = open(path);
  return file ? (*file)->write(bytes) : file.error();
}

void OutputSet::leaveOut(const std::string& path) {
  outputs_.remove_if([&](const Output& output) { return output.path == path; });
}

Status OutputSet::commit() {
  for (Output& output : outputs_)
    if (const Status complete = output.file.complete(); !complete) return complete;
  std::set<std::string> folders;
  {
    const Undisturbed whole;
    for (Output& output : outputs_)
      if (const Status delivered = output.file.deliver(); !delivered) return delivered;
    if (outputs_.size() > 1)
      for (Output& output : outputs_) output.file.keepOld();
    for (auto output = outputs_.begin(); output != outputs_.end(); ++output) {
      const Status placed = output->file.place();
      if (placed) continue;
      std::for_each(outputs_.begin(), output, [](Output& before) { before.file.putBack(); });
      return placed;
    }
    for (const Output& output : outputs_) {
      if (output.file.direct()) continue;
      noteWritten(Written::files);
      const std::filesystem::path folder = std::filesystem::path(output.file.path()).parent_path();
      folders.insert(folder.empty() ? "." : folder.string());
    }
    outputs_.clear();
  }
  if (flush_ == Flush::yes) std::for_each(folders.begin(), folders.end(), flushFolder);
  return success();
}

Status writeWhole(const std::string& path, std::string_view bytes, Flush flush) {
  OutputSet set(flush);
  if (const Status written = set.write(path, bytes); !written) return written;
  return set.commit();
}

}  // namespace triscope

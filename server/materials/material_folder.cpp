#include "server/materials/material_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

namespace gonio::server {
namespace {

namespace fs = std::filesystem;

Error cannot_store(const std::string& what, int reason) {
  const bool full = reason == ENOSPC || reason == EDQUOT;
  return {full ? ErrorCode::resource_exhausted : ErrorCode::internal,
          "the server cannot store the material: " + what + ": " + std::strerror(reason),
          {},
          {},
          full ? "what there is room for on its disk" : ""};
}

Error taken(const std::string& name) {
  return bad_value("file.name", "\"" + name + "\", for which the materials folder has a file",
                   "a name that no stored material has", ErrorCode::already_exists);
}

// Of a file that is not there as a whole yet; not loaded, for it is neither .json nor .binary.
constexpr std::string_view kTemporary = ".put-", kPattern = "XXXXXX";

// Is it a name that mkostemp() makes of these?
bool is_temporary(std::string_view name) {
  const std::string_view end = name.substr(std::min(kTemporary.size(), name.size()));
  return name.substr(0, kTemporary.size()) == kTemporary && end.size() == kPattern.size() &&
         std::all_of(end.begin(), end.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
}

// Whoever has the lock may remove the file. It ends with the process that has it, however that
// ends.
bool lock(const Descriptor& file) { return ::flock(file.number(), LOCK_EX | LOCK_NB) == 0; }

bool has_name(const Descriptor& file) {
  struct stat status {};
  return ::fstat(file.number(), &status) == 0 && status.st_nlink > 0;
}

// 0, or errno.
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fchmod(descriptor, 0644) == 0 && ::fsync(descriptor) == 0 ? 0 : errno;
}

// The new name reaches the disk with the folder.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

bool can_be_written(const fs::path& folder) { return ::access(folder.c_str(), W_OK | X_OK) == 0; }

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

std::size_t remove_leftovers(const fs::path& folder) {
  std::size_t removed = 0;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    std::error_code failed;
    if (!is_temporary(entry->path().filename().string()) ||
        !fs::is_regular_file(entry->symlink_status(failed))) {
      continue;
    }
    const Descriptor file(::open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
    if (file.number() < 0 || !lock(file)) continue;
    if (fs::remove(entry->path(), failed)) ++removed;
  }
  return removed;
}

Result<NewFile> NewFile::create(const fs::path& folder, std::string_view content) {
  for (;;) {
    std::string name = folder / (std::string(kTemporary) + std::string(kPattern));
    Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
    if (file.number() < 0) return cannot_store("no file can be created", errno);
    // Before it was locked, a server that starts may have taken it for a leftover. Where nothing
    // can be locked, nothing is taken for one.
    if (!lock(file) && errno == EWOULDBLOCK) continue;
    if (!has_name(file)) continue;
    NewFile created(folder, name, std::move(file));
    const int problem = write_all(created.locked_.number(), content);
    if (problem != 0) return cannot_store("the file cannot be written", problem);
    return created;
  }
}

NewFile::~NewFile() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

NewFile::NewFile(NewFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      temporary_(std::exchange(other.temporary_, {})),
      locked_(std::move(other.locked_)) {}

NewFile& NewFile::operator=(NewFile&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(temporary_, other.temporary_);
  std::swap(locked_, other.locked_);
  return *this;
}

Outcome NewFile::place(const std::string& name) {
  std::error_code ignored;
  // With both, the next start would not know which is meant.
  if (fs::exists(folder_ / (name + ".json"), ignored)) return taken(name);
  const fs::path target = folder_ / (name + ".binary");
  // Unlike rename(), it does not replace what another process has put there meanwhile.
  if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) != 0)
    return errno == EEXIST ? Outcome(taken(name)) : cannot_store("it cannot be named", errno);
  temporary_.clear();
  locked_ = Descriptor();
  sync_folder(folder_);
  return Ok{};
}

}  // namespace gonio::server

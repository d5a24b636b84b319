#include "client/cli/chart/panel/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

namespace fs = std::filesystem;

Error failure(const std::string& what) { return {ErrorCode::internal, shown(what), {}, {}, {}}; }

// A folder that goes away with this.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code ignored;
    const fs::path parent = fs::temp_directory_path(ignored);
    std::string pattern = (ignored ? fs::path("/tmp") : parent) / "gonio-chart.XXXXXX";
    if (::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }  // empty if there is none

 private:
  fs::path path_;
};

std::optional<std::string> content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

// The exit status of `gnuplot script` in a folder, its messages in the file `messages` there; or
// the errno of what kept it from starting.
struct Ended {
  int errno_of_start = 0;
  int status = 0;
};
Ended gnuplot_in(const fs::path& folder) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, descriptor, "messages",
                                     O_WRONLY | O_CREAT | O_APPEND, 0600);
  }
  std::string program = "gnuplot", script = "script";
  char* arguments[] = {program.data(), script.data(), nullptr};
  pid_t child = 0;
  Ended ended;
  ended.errno_of_start =
      ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (ended.errno_of_start != 0) return ended;
  while (::waitpid(child, &ended.status, 0) < 0 && errno == EINTR) {
  }
  return ended;
}

}  // namespace

Result<std::vector<Drawing>> run_gnuplot(const std::string& script, const std::string& name) {
  const TemporaryFolder folder;
  if (folder.path().empty())
    return failure(std::string("no temporary folder can be made: ") + std::strerror(errno));
  std::ofstream file(folder.path() / "script", std::ios::binary);
  if (!(file << script) || !file.flush())
    return failure((folder.path() / "script").string() + " cannot be written");
  const Ended ended = gnuplot_in(folder.path());
  if (ended.errno_of_start == ENOENT) {
    return Error{
        ErrorCode::not_found, "gnuplot is not installed (Debian: gnuplot-nox)", {}, {}, {}};
  }
  if (ended.errno_of_start != 0)
    return failure(std::string("gnuplot cannot be started: ") +
                   std::strerror(ended.errno_of_start));
  if (ended.status != 0)
    return failure("gnuplot failed on " + name + ": " +
                   content_of(folder.path() / "messages").value_or(""));
  std::vector<Drawing> drawings;
  for (const std::string& drawn : {name + ".svg", name + ".png"}) {
    auto bytes = content_of(folder.path() / drawn);
    if (!bytes || bytes->empty()) return failure("gnuplot made no " + drawn);
    drawings.push_back({drawn, std::move(*bytes)});
  }
  return drawings;
}

}  // namespace gonio::cli

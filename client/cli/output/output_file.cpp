#include "client/cli/output/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "client/cli/output/terminal.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

namespace fs = std::filesystem;

// The temporary files of this process, for the signal handler: paths, or empty texts. A command
// that writes more files at a time than this has no more to lose than names that begin with a dot.
using Path = std::array<char, 4096>;
std::array<Path, 16> temporaries_of_process{};

Path* slot_of(std::string_view path) {
  const auto found = std::find_if(temporaries_of_process.begin(), temporaries_of_process.end(),
                                  [&](const Path& slot) { return slot.data() == path; });
  return found == temporaries_of_process.end() ? nullptr : &*found;
}

void remember(const std::string& path) {
  Path* slot = slot_of({});
  if (slot == nullptr || path.empty() || path.size() >= slot->size()) return;
  // Its first byte comes last: a signal in between finds an empty text.
  std::memcpy(slot->data() + 1, path.c_str() + 1, path.size());
  std::atomic_signal_fence(std::memory_order_seq_cst);
  (*slot)[0] = path[0];
}

void forget(const std::string& path) {
  if (Path* slot = slot_of(path)) (*slot)[0] = '\0';
}

extern "C" void remove_and_die(int signal) {
  for (const Path& path : temporaries_of_process) {
    if (path[0] != '\0') ::unlink(path.data());
  }
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

mode_t usual_mode() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

void handle_signals() {
  ::signal(SIGPIPE, SIG_IGN);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // What whoever started this has chosen to ignore (nohup) stays ignored.
    if (::signal(signal, remove_and_die) == SIG_IGN) ::signal(signal, SIG_IGN);
  }
}

Result<OutputFile> OutputFile::open(const std::string& file, bool rewind) {
  std::error_code error;
  const bool in_place =
      file == "-" || (fs::exists(file, error) && !fs::is_regular_file(file, error));
  if (!in_place) return create_temporary(file);
  OutputFile output;
  output.name_ = file == "-" ? "standard output" : file;
  output.descriptor_ = file == "-" ? STDOUT_FILENO : ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (output.descriptor_ < 0) return output.cannot_write(errno);
  if (rewind) output.spool_.reset(std::tmpfile());
  if (rewind && !output.spool_) return output.cannot_write(errno);
  return output;
}

Outcome print(const std::string& text) {
  auto output = OutputFile::open("-");
  if (!output) return output.error();
  const auto written = output->write(shown_lines(text));
  return output->reader_gone() ? Outcome(Ok{}) : written;
}

Outcome print_table(const std::string& text, bool stdout_is_taken) {
  if (!stdout_is_taken) return print(text);
  print_lines(text);
  return Ok{};
}

Result<OutputFile> OutputFile::create_temporary(const std::string& file) {
  OutputFile output;
  output.name_ = file;
  std::error_code error;
  // Through a symbolic link, the file that it names is replaced and not the link.
  const fs::path target =
      fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : fs::path(file);
  output.target_ = target.string();
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::string pattern = (folder / ("." + target.filename().string() + ".XXXXXX")).string();
  output.descriptor_ = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (output.descriptor_ < 0) return output.cannot_write(errno);
  output.temporary_ = pattern;
  remember(pattern);
  struct stat old {};
  const bool exists = ::stat(output.target_.c_str(), &old) == 0;
  ::fchmod(output.descriptor_, exists ? old.st_mode & 07777U : usual_mode());
  return output;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      spool_(std::move(other.spool_)),
      reader_gone_(other.reader_gone_) {}

OutputFile::~OutputFile() { discard(); }

void OutputFile::discard() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  descriptor_ = -1;
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  forget(temporary_);
  temporary_.clear();
}

Error OutputFile::cannot_write(int reason) {
  reader_gone_ = reason == EPIPE;
  const std::string name = shown(name_);
  return {ErrorCode::internal, name + " cannot be written: " + std::strerror(reason), {}, name, {}};
}

Outcome OutputFile::write_to(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return cannot_write(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return Ok{};
}

Outcome OutputFile::write(std::string_view bytes) {
  return write_to(spool_ ? ::fileno(spool_.get()) : descriptor_, bytes);
}

Outcome OutputFile::patch(std::string_view bytes) {
  const int descriptor = spool_ ? ::fileno(spool_.get()) : descriptor_;
  if (::lseek(descriptor, 0, SEEK_SET) < 0) return cannot_write(errno);
  if (auto written = write_to(descriptor, bytes); !written) return written;
  if (::lseek(descriptor, 0, SEEK_END) < 0) return cannot_write(errno);
  return Ok{};
}

Outcome OutputFile::copy_spool() {
  const int from = ::fileno(spool_.get());
  if (::lseek(from, 0, SEEK_SET) < 0) return cannot_write(errno);
  std::string block(std::size_t{1} << 18, '\0');
  for (;;) {
    const ssize_t got = ::read(from, block.data(), block.size());
    if (got < 0) return cannot_write(errno);
    if (got == 0) return Ok{};
    const std::string_view bytes(block.data(), static_cast<std::size_t>(got));
    if (auto written = write_to(descriptor_, bytes); !written) return written;
  }
}

Outcome OutputFile::commit() {
  if (spool_) {
    if (auto copied = copy_spool(); !copied) return copied;
  }
  if (temporary_.empty()) return Ok{};
  // A full disk may show no earlier than here.
  const int closed = ::close(std::exchange(descriptor_, -1));
  if (closed != 0 || ::rename(temporary_.c_str(), target_.c_str()) != 0) return cannot_write(errno);
  forget(temporary_);
  temporary_.clear();
  return Ok{};
}

Outcome OutputFile::write_whole(std::string_view bytes) {
  if (auto written = write(bytes); !written) return written;
  return commit();
}

}  // namespace gonio::cli

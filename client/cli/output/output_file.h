// Where results go: standard output, or a file that appears complete or not at all. Thread safety:
// used by one thread.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio::cli {

class OutputFile {
 public:
  // "-" is standard output. A regular file is written beside its place under another name and
  // renamed by commit(); a device or a pipe is written to as it is. `rewind`: patch() is going to
  // be called. Errors: why it cannot be written.
  static Result<OutputFile> open(const std::string& file, bool rewind = false);

  ~OutputFile();  // without commit() nothing is left behind
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;

  Outcome write(std::string_view bytes);
  // Overwrites the beginning. Only with `rewind`.
  Outcome patch(std::string_view bytes);
  // All is written: the file takes its place.
  Outcome commit();
  // write() and commit().
  Outcome write_whole(std::string_view bytes);

  // The reader of a pipe went away: not a failure of ours.
  [[nodiscard]] bool reader_gone() const { return reader_gone_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  OutputFile() = default;
  static Result<OutputFile> create_temporary(const std::string& file);
  Error cannot_write(int reason);
  Outcome write_to(int descriptor, std::string_view bytes);
  Outcome copy_spool();
  void discard();

  std::string name_;       // for messages
  std::string target_;     // where the file belongs; empty if it is written in place
  std::string temporary_;  // where it is until commit()
  int descriptor_ = -1;
  std::unique_ptr<std::FILE, Close> spool_;  // for what has to be patched but cannot be sought in
  bool reader_gone_ = false;
};

// Lines for people to standard output, each as shown() shows it. A reader that went away is no
// error.
Outcome print(const std::string& text);
// A table for people must not stand among results that are read from standard output.
Outcome print_table(const std::string& text, bool stdout_is_taken);

// Makes SIGINT, SIGTERM and SIGHUP remove the temporary files on their way (but for one that is
// made in that moment), and a broken pipe an error instead of a signal.
void handle_signals();

}  // namespace gonio::cli

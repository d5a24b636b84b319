// goniod as a real process, its log read line by line.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace gonio::server::testing {

class Daemon {
 public:
  explicit Daemon(std::vector<std::string> arguments) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    arguments.insert(arguments.begin(), GONIOD);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    pid_ = fork();
    if (pid_ == 0) {
      dup2(ends[1], STDERR_FILENO);
      dup2(ends[1], STDOUT_FILENO);
      execv(GONIOD, argv.data());
      _exit(127);
    }
    close(ends[1]);
    output_ = ends[0];
  }
  ~Daemon() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      wait_for_exit();
    }
    close(output_);
  }
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  // Reads on until a line holds `text`; empty if the output ends before.
  std::string line_with(const std::string& text) {
    for (std::string line; read_line(line);) {
      if (line.find(text) != std::string::npos) return line;
    }
    return {};
  }

  // The port behind the next "listening on HOST:PORT".
  int port() {
    const std::string line = line_with("listening on 127");
    const std::size_t at = line.find(':', line.find("listening on"));
    return at == std::string::npos ? 0 : std::stoi(line.substr(at + 1));
  }

  void send(int signal) const { ::kill(pid_, signal); }

  // The exit code; -signal if one ended it.
  int wait_for_exit() {
    int status = 0;
    waitpid(std::exchange(pid_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  // Everything printed so far, once the process has ended.
  std::string all_output() {
    for (std::string line; read_line(line);) {
    }
    return seen_;
  }

  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  bool read_line(std::string& line) {
    line.clear();
    for (char c = 0; read(output_, &c, 1) == 1;) {
      seen_.push_back(c);
      if (c == '\n') return true;
      line.push_back(c);
    }
    return !line.empty();
  }

  pid_t pid_ = 0;
  int output_ = -1;
  std::string seen_;
};

}  // namespace gonio::server::testing

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>

#include "client/cli/commands/commands.h"
#include "client/cli/connection/connection.h"
#include "client/cli/input/file_kind.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/output_file.h"
#include "client/cli/output/progress.h"
#include "gonio/measured/table.h"
#include "measured/file_error.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFooter = R"(
The file is sent once, checked by its SHA-256, and stored as a whole or not at all: in the server's materials
folder (goniod --materials) if there is one that it can write to, else in its memory until it ends. The
name is then a material like any other: gonio evaluate --material NAME, gonio fit --data NAME.
Nothing is replaced: a name that is taken is an error, unless by the same bytes.

Example:
  gonio put --server localhost:50051 nickel nickel.binary)";

struct PutArguments {
  std::string server;
  double deadline = 0;
  std::string name, file;
  bool quiet = false;
};

Error bad_file(const std::string& file, ErrorCode code, const std::string& found) {
  const std::string allowed =
      "a MERL .binary file of " + std::to_string(MeasuredTable::kFileBytes) + " bytes";
  return file_error(code, file, found, allowed);
}

// What has another size is not read: it is no such file, however large it is.
Result<std::string> read_content(const std::string& file) {
  std::error_code problem;
  const auto status = fs::status(file, problem);
  if (!fs::exists(status))
    return bad_file(file, ErrorCode::not_found, "no such file" + near_files(file));
  if (!fs::is_regular_file(status))
    return bad_file(file, ErrorCode::invalid_argument, "a folder, pipe or device");
  const auto size = fs::file_size(file, problem);
  if (problem) return bad_file(file, ErrorCode::not_found, problem.message());
  if (size != MeasuredTable::kFileBytes) {
    const FileKind kind = kind_of_file(file).value_or(FileKind::unknown);
    const std::string what = kind == FileKind::unknown ? "" : ", " + description_of(kind);
    return bad_file(file, ErrorCode::data_loss, std::to_string(size) + " bytes" + what);
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) return bad_file(file, ErrorCode::not_found, std::strerror(errno));
  std::string content(MeasuredTable::kFileBytes, '\0');
  if (!in.read(content.data(), static_cast<std::streamsize>(content.size())))
    return bad_file(file, ErrorCode::data_loss, "an end before the last byte");
  return content;
}

std::string summary_of(const PutArguments& arguments, const client::PutReport& report) {
  const char* place = report.place == client::PutPlace::folder
                          ? "in the server's materials folder"
                          : "in the server's memory, until it ends";
  return arguments.name + ": " + (report.existed ? "was there already, " : "stored ") + place +
         "\n" + std::to_string(report.cells) + " cells, " + std::to_string(report.invalid_cells) +
         " of them not measured\nsha256 " + report.sha256 + "\n";
}

int run(const PutArguments& arguments) {
  if (arguments.server.empty()) {
    return fail(bad_value("--server", "not given",
                          "the address of a goniod: without one there is nothing to put into"));
  }
  const auto content = read_content(arguments.file);
  if (!content) return fail(content.error());
  ConnectionOptions options;
  options.server = arguments.server;
  options.deadline = arguments.deadline;
  auto connection = Connection::open(options);
  if (!connection) return fail(connection.error());
  client::PutWatch watch;
  auto progress = std::make_unique<Progress>(!arguments.quiet, "bytes");
  watch.progress = [&](double part) { progress->show(part, "sending"); };
  const auto report = connection->client.put_material(arguments.name, *content, watch);
  progress.reset();
  if (!report) return fail(report.error());
  if (arguments.quiet) return exit_ok;
  const auto shown = print(summary_of(arguments, *report));
  return shown ? exit_ok : fail(shown.error());
}

}  // namespace

Command add_put_command(CLI::App& app) {
  auto arguments = std::make_shared<PutArguments>();
  CLI::App& command = arguments::add_command(app, "put", "Store a measured material on a server");
  arguments::set_footer(command, kFooter);
  arguments::add_option(command, "NAME", arguments->name,
                        "What it will be called: 1 to 100 letters, digits, '-' and '_'")
      .type_name("")
      .required();
  arguments::add_option(command, "FILE", arguments->file, "A MERL .binary file")
      .type_name("")
      .required();
  arguments::add_option(command, "--server", arguments->server,
                        "The goniod to ask, HOST:PORT or unix:/PATH")
      .type_name("ADDRESS")
      .environment("GONIO_SERVER");
  arguments::add_option(command, "--deadline", arguments->deadline,
                        "Give up after this long; 0 for never")
      .type_name("SECONDS")
      .range(0.0, 1e9);
  arguments::add_flag(command, "--quiet,-q", arguments->quiet, "No progress bar and no summary");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli

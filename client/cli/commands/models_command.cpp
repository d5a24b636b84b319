#include <cstdio>
#include <memory>
#include <string>

#include "client/cli/commands/commands.h"
#include "client/cli/connection/connection.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/output_file.h"
#include "client/cli/report/markdown.h"
#include "client/cli/report/model_page.h"
#include "client/cli/report/presets.h"
#include "client/cli/tool/known_names.h"
#include "gonio/base/shown.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

struct Arguments {
  ConnectionOptions connection;
  std::string name;
  bool json = false, presets = false, markdown = false;
};

Result<std::string> text_for(const client::Client& client, const Arguments& arguments) {
  if (arguments.json && !arguments.presets) {
    auto json = client.list_models_json(arguments.name);
    if (!json) return json;
    return *json + "\n";
  }
  auto catalogue = client.list_models(arguments.name);
  if (!catalogue) return catalogue.error();
  if (!arguments.name.empty() && catalogue->models.empty()) {
    return Error{ErrorCode::not_found,
                 "there is no model '" + shown(arguments.name, kQuotedLength) + "'",
                 "name",
                 shown(arguments.name, kQuotedLength),
                 {}};
  }
  if (arguments.presets) return arguments.json ? preset_json(*catalogue) : preset_table(*catalogue);
  if (arguments.markdown) return markdown(*catalogue);
  return arguments.name.empty() ? model_table(*catalogue) : model_page(catalogue->models.front());
}

int run(const Arguments& arguments) {
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  auto text = text_for(connection->client, arguments);
  if (!text) return fail(text.error());
  const auto written = print(*text);
  return written ? exit_ok : fail(written.error());
}

}  // namespace

Command add_models_command(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command = arguments::add_command(
      app, "models", "List the models and stored materials, or describe one model");
  arguments::add_option(command, "NAME", arguments->name, "The model to describe")
      .type_name("")
      .suggest(model_names());
  const arguments::Option json = arguments::add_flag(
      command, "--json", arguments->json,
      "Print JSON instead of text: gonio.v1.ListModelsResponse, or the presets");
  const arguments::Option presets =
      arguments::add_flag(command, "--presets", arguments->presets,
                          "List the names that may stand in the place of numbers");
  arguments::add_flag(command, "--markdown", arguments->markdown,
                      "Print models, parameters and presets as Markdown tables")
      .excludes(json)
      .excludes(presets);
  add_connection_options(command, arguments->connection);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli

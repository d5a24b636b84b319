#include "client/cli/select_report.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <cstdio>

#include "client/cli/json.h"
#include "client/cli/numbers.h"
#include "client/cli/text.h"
#include "server/material_message.h"

namespace gonio::cli {
namespace {

constexpr std::size_t kCell = 10;

std::string cell(double x) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", x);
  return padded(text, kCell);
}

std::size_t name_width(const select::Selection& selection) {
  std::size_t width = 0;
  for (const select::Entry& entry : selection.entries) width = std::max(width, entry.name.size());
  return width + 2;
}

std::string row(const select::Entry& entry, bool chosen, std::size_t width) {
  const std::string mark = chosen ? "*" : entry.on_front ? "o" : " ";
  return mark + " " + padded(entry.name, width) + cell(static_cast<double>(entry.parameters)) +
         cell(entry.ns) + cell(static_cast<double>(entry.bytes)) + cell(entry.cost) +
         cell(entry.error.value) + cell(entry.error.upper) + (chosen ? "chosen" : entry.remark) +
         "\n";
}

std::string bounded_json(const select::Bounded& error) {
  return "{\"value\": " + shortest(error.value) + ", \"lower\": " + shortest(error.lower) +
         ", \"upper\": " + shortest(error.upper) + "}";
}

std::string entry_json(const select::Entry& entry) {
  std::string fields;
  for (const std::string& field : entry.at_bounds)
    fields += (fields.empty() ? "" : ", ") + json_string(field);
  std::string json = "{\"name\": " + json_string(entry.name) +
                     ", \"parameters\": " + std::to_string(entry.parameters) +
                     ", \"ns\": " + shortest(entry.ns) +
                     ", \"bytes\": " + std::to_string(entry.bytes);
  if (entry.second_moment > 0) json += ", \"second_moment\": " + shortest(entry.second_moment);
  return json + ", \"cost\": " + shortest(entry.cost) +
         ", \"error\": " + bounded_json(entry.error) +
         ", \"on_front\": " + (entry.on_front ? "true" : "false") +
         ", \"meets\": " + (entry.meets ? "true" : "false") + ", \"at_bounds\": [" + fields +
         "], \"remark\": " + json_string(entry.remark) +
         ", \"material\": " + material_json(entry.material) + "}";
}

std::string choice_json(const select::Selection& selection) {
  const select::Choice& choice = *selection.choice;
  return "{\"name\": " + json_string(selection.entries[choice.entry].name) +
         ", \"material\": " + material_json(choice.material) +
         ", \"digits\": " + std::to_string(choice.digits) +
         ", \"precision\": " + json_string(name_of(choice.precision)) +
         ", \"float32_error\": " + shortest(choice.float32_error) +
         ", \"error\": " + bounded_json(choice.error) +
         ", \"confidence\": " + shortest(choice.confidence) +
         ", \"pairs\": " + std::to_string(choice.pairs) + "}";
}

}  // namespace

std::string material_json(const MaterialSpec& spec) {
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(to_wire(spec), &json);
  return status.ok() ? json : "{}";
}

std::string select_table(const select::Selection& selection, bool all) {
  const std::size_t width = name_width(selection);
  std::string text = "  " + padded("candidate", width);
  for (const char* head : {"numbers", "ns", "bytes", "cost", "error", "at most"})
    text += padded(head, kCell);
  text += "\n";
  for (std::size_t i = 0; i < selection.entries.size(); ++i) {
    const bool chosen = selection.choice && selection.choice->entry == i;
    const select::Entry& entry = selection.entries[i];
    if (all || chosen || entry.on_front) text += row(entry, chosen, width);
  }
  return text + "\n" + wrapped(selection.reason, 0) + "\n";
}

std::string select_json(const select::Selection& selection) {
  std::string json = "{\"choice\": ";
  json += selection.choice ? choice_json(selection) : "null";
  json += ",\n\"reason\": " + json_string(selection.reason) + ",\n\"candidates\": [";
  const char* separator = "\n";
  for (const select::Entry& entry : selection.entries) {
    json += separator + entry_json(entry);
    separator = ",\n";
  }
  return json + "]}\n";
}

}  // namespace gonio::cli

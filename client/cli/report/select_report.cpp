#include "client/cli/report/select_report.h"

#include <algorithm>
#include <cstdio>

#include "client/cli/output/json.h"
#include "client/cli/output/text.h"

namespace gonio::cli {
namespace {

constexpr std::size_t kCell = 10;
constexpr const char* kErrors =
    "Searched: the error on the directions used to compare candidates. Certified: the error of the "
    "choice on directions used neither to fit nor to choose it.";

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", x);
  return text;
}

std::string cell(double x) { return padded(number(x), kCell); }

// "816 B", "3.1 kB", "17 MB"
std::string bytes(double count) {
  if (count < 1e3) return number(count) + " B";
  return count < 1e6 ? number(count / 1e3) + " kB" : number(count / 1e6) + " MB";
}

template <class Items, class NameOf>
std::size_t width_of(const Items& items, const NameOf& name_of, std::size_t least) {
  std::size_t width = least;
  for (const auto& item : items) width = std::max(width, name_of(item).size());
  return width + 2;
}

// Of the choice both errors are known, by name.
std::string chosen_remark(const client::SelectChoice& choice) {
  return "chosen; certified " + number(choice.error.value) + ", at most " +
         number(choice.error.upper);
}

std::string row(const client::SelectEntry& entry, const client::SelectChoice* choice,
                std::size_t width) {
  const std::string mark = choice != nullptr ? "*" : entry.on_front ? "o" : " ";
  return mark + " " + padded(entry.name, width) + padded(std::to_string(entry.parameters), kCell) +
         cell(entry.ns) + padded(bytes(static_cast<double>(entry.bytes)), kCell) +
         cell(entry.cost) + cell(entry.error.value) + cell(entry.error.upper) +
         (choice != nullptr ? chosen_remark(*choice) : entry.remark) + "\n";
}

const client::SelectEntry* chosen_of(const NamedSelection& material) {
  const client::Selection& found = material.selection;
  return found.choice ? &found.entries[found.choice->entry] : nullptr;
}

// Measured pairs have no cost of their own.
const client::SelectEntry* reference_of(const NamedSelection& material) {
  const auto& entries = material.selection.entries;
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [](const auto& entry) { return !entry.material.has_value(); });
  return found == entries.end() ? nullptr : &*found;
}

std::string costs(const client::SelectEntry* entry) {
  if (entry == nullptr) return padded("-", kCell) + padded("-", kCell);
  return cell(entry->ns) + padded(bytes(static_cast<double>(entry->bytes)), kCell);
}

std::string chosen_name(const NamedSelection& material) {
  const client::SelectEntry* chosen = chosen_of(material);
  return chosen == nullptr ? "nothing" : chosen->name;
}

// What the materials cost that can be compared: those of which both costs are known. Where nothing
// is good enough, the reference stays.
struct Saved {
  std::size_t materials = 0;
  double ns_before = 0, ns_after = 0, bytes_before = 0, bytes_after = 0;
};

Saved saved_by(const std::vector<NamedSelection>& materials) {
  Saved saved;
  for (const NamedSelection& material : materials) {
    const client::SelectEntry *before = reference_of(material), *after = chosen_of(material);
    if (before == nullptr) continue;
    if (after == nullptr) after = before;
    ++saved.materials;
    saved.ns_before += before->ns, saved.ns_after += after->ns;
    saved.bytes_before += static_cast<double>(before->bytes);
    saved.bytes_after += static_cast<double>(after->bytes);
  }
  return saved;
}

std::string saved_line(const std::vector<NamedSelection>& materials) {
  const Saved saved = saved_by(materials);
  if (saved.materials == 0) return "";
  return "Saved: an evaluation of each costs " + number(saved.ns_after) +
         " ns together instead of " + number(saved.ns_before) + ", and they hold " +
         bytes(saved.bytes_after) + " instead of " + bytes(saved.bytes_before) + ".\n";
}

}  // namespace

std::string select_table(const client::Selection& selection, bool all) {
  const std::size_t width = width_of(
      selection.entries, [](const auto& entry) { return entry.name; }, 9);
  std::string text = "  " + padded("candidate", width);
  for (const char* head : {"numbers", "ns", "bytes", "cost", "searched", "at most"})
    text += padded(head, kCell);
  text += "\n";
  for (std::size_t i = 0; i < selection.entries.size(); ++i) {
    const bool chosen = selection.choice && selection.choice->entry == i;
    const client::SelectEntry& entry = selection.entries[i];
    if (all || chosen || entry.on_front)
      text += row(entry, chosen ? &*selection.choice : nullptr, width);
  }
  return text + "\n" + wrapped(kErrors, 0) + "\n" + wrapped(selection.reason, 0) + "\n";
}

std::string scene_table(const std::vector<NamedSelection>& materials) {
  const std::size_t name = width_of(
                        materials, [](const auto&m) { return m.name; }, 8),
                    choice = width_of(materials, chosen_name, 6);
  std::string text = padded("material", name) + padded("ns", kCell) + padded("bytes", kCell) +
                     padded("choice", choice) + padded("ns", kCell) + padded("bytes", kCell) +
                     padded("certified", kCell) + "at most\n";
  for (const NamedSelection& material : materials) {
    text += padded(material.name, name) + costs(reference_of(material)) +
            padded(chosen_name(material), choice) + costs(chosen_of(material));
    const auto& found = material.selection.choice;
    text +=
        found ? cell(found->error.value) + number(found->error.upper) : padded("-", kCell) + "-";
    text += "\n";
  }
  text += "\n" + saved_line(materials);
  for (const NamedSelection& material : materials)
    text += wrapped(material.name + ": " + material.selection.reason, 0) + "\n";
  return text;
}

std::string select_json(const std::vector<NamedSelection>& materials) {
  if (materials.size() == 1 && materials[0].name.empty()) return materials[0].selection.json;
  std::string json = "{";
  const char* separator = "\n";
  for (const NamedSelection& material : materials) {
    json += separator + json_string(material.name) + ": " + material.selection.json;
    separator = ",\n";
  }
  return json + "}\n";
}

}  // namespace gonio::cli

#include "client/messages/select_convert.h"

#include <utility>

#include "client/messages/message_json.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

SelectError error_of(const v1::SelectError& from) {
  return {from.value(), from.lower(), from.upper()};
}

// None where there is none.
template <class From>
Outcome read_material(const From& from, std::optional<Material>& to) {
  if (!from.has_material()) return Ok{};
  auto material = material_of(from.material());
  if (!material) return material.error();
  to = std::move(*material);
  return Ok{};
}

SelectEntry entry_of(const v1::SelectEntry& from) {
  SelectEntry to;
  to.name = from.name();
  to.parameters = from.parameters();
  to.ns = from.ns(), to.bytes = from.bytes();
  to.second_moment = from.second_moment();
  to.cost = from.cost();
  to.error = error_of(from.error());
  to.at_bounds = {from.at_bounds().begin(), from.at_bounds().end()};
  to.on_front = from.on_front(), to.meets = from.meets();
  to.remark = from.remark();
  return to;
}

SelectChoice choice_of(const v1::SelectChoice& from) {
  SelectChoice to;
  to.entry = from.entry();
  to.digits = from.digits();
  to.needs_float64 = from.needs_float64();
  to.float32_error = from.float32_error();
  to.error = error_of(from.error());
  to.confidence = from.confidence();
  to.pairs = from.pairs();
  return to;
}

}  // namespace

Result<Selection> selection_of(const v1::SelectResult& result) {
  auto json = json_of(result);
  if (!json) return json.error();
  Selection selection;
  for (const auto& entry : result.entries()) {
    selection.entries.push_back(entry_of(entry));
    if (auto read = read_material(entry, selection.entries.back().material); !read)
      return read.error();
  }
  if (result.has_choice()) {
    selection.choice = choice_of(result.choice());
    if (auto read = read_material(result.choice(), selection.choice->material); !read)
      return read.error();
    if (selection.choice->entry >= selection.entries.size())
      return Error{ErrorCode::internal, "the server chose what it did not try", {}, {}, {}};
  }
  selection.reason = result.reason();
  selection.json = std::move(*json);
  return selection;
}

}  // namespace gonio::client

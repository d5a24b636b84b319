#include "server/messages/select_messages.h"

#include "server/messages/material_message.h"

namespace gonio::server {
namespace {

void fill(const select::Bounded& from, v1::SelectError& to) {
  to.set_value(from.value);
  to.set_lower(from.lower);
  to.set_upper(from.upper);
}

void fill(const select::Entry& from, v1::SelectEntry& to) {
  to.set_name(from.name);
  if (select::has_model(from.material)) *to.mutable_material() = to_wire(from.material);
  to.set_parameters(from.parameters);
  to.set_ns(from.ns);
  to.set_bytes(from.bytes);
  to.set_second_moment(from.second_moment);
  to.set_cost(from.cost);
  fill(from.error, *to.mutable_error());
  to.mutable_at_bounds()->Assign(from.at_bounds.begin(), from.at_bounds.end());
  to.set_on_front(from.on_front);
  to.set_meets(from.meets);
  to.set_remark(from.remark);
}

void fill(const select::Choice& from, v1::SelectChoice& to) {
  to.set_entry(from.entry);
  if (select::has_model(from.material)) *to.mutable_material() = to_wire(from.material);
  to.set_digits(static_cast<std::uint32_t>(from.digits));
  to.set_needs_float64(from.precision == Precision::reference);
  to.set_float32_error(from.float32_error);
  fill(from.error, *to.mutable_error());
  to.set_confidence(from.confidence);
  to.set_pairs(from.pairs);
}

}  // namespace

v1::SelectResult to_wire(const select::Selection& selection) {
  v1::SelectResult result;
  for (const select::Entry& entry : selection.entries) fill(entry, *result.add_entries());
  if (selection.choice) fill(*selection.choice, *result.mutable_choice());
  result.set_reason(selection.reason);
  return result;
}

}  // namespace gonio::server

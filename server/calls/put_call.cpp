#include "server/calls/put_call.h"

#include <grpcpp/server_context.h>

#include <utility>

#include "gonio/measured/table.h"
#include "wire/message.h"
#include "wire/status.h"

namespace gonio::server {
namespace {

constexpr const char* kPutPushbackMilliseconds = "1000";

v1::PutMaterialResponse to_wire(const std::string& name, const PutResult& result) {
  v1::PutMaterialResponse response;
  response.set_name(name);
  response.set_place(result.place == PutPlace::folder ? v1::MATERIAL_PLACE_FOLDER
                                                      : v1::MATERIAL_PLACE_MEMORY);
  response.set_cells(MeasuredTable::kCells);
  response.set_invalid_cells(result.invalid_cells);
  response.set_existed(result.existed);
  return response;
}

Error cancelled() { return {ErrorCode::cancelled, "the upload was cancelled", {}, {}, {}}; }

}  // namespace

PutCall::PutCall(const Backend& backend, grpc::CallbackServerContext& context,
                 grpc::ByteBuffer& response)
    : backend_(backend),
      context_(context),
      response_(response),
      state_(context.deadline()),
      access_("PutMaterial", "bytes", context, backend.logger),
      upload_(backend.materials, backend.memory) {}

PutCall* PutCall::start(const Backend& backend, grpc::CallbackServerContext& context,
                        grpc::ByteBuffer& response) {
  auto* call = new PutCall(backend, context, response);
  happens_before(&call->state_);
  call->read();
  return call;
}

void PutCall::read() {
  happens_before(&incoming_);
  StartRead(&incoming_);
}

// Not ok: the client has sent all, or is gone.
void PutCall::OnReadDone(bool ok) {
  const Reaction reaction(this, &incoming_);
  if (ok) {
    if (auto taken = take(); !taken) return refuse(taken.error());
    return read();
  }
  if (state_.is_over() || context_.IsCancelled()) return refuse(cancelled());
  Outcome stored = upload_.finish();
  if (stored) stored = queue_storing();
  if (!stored) refuse(stored.error());
}

Outcome PutCall::take() {
  v1::PutMaterialRequest part;
  if (!wire::from_buffer(incoming_, part))
    return bad_value("request", "not a " + part.GetTypeName(), "the bytes of one");
  incoming_.Clear();
  return upload_.take(part);
}

Outcome PutCall::queue_storing() {
  access_.items = upload_.size();
  if (backend_.puts.submit({[this] { store(); }, [this] { return state_.is_over(); }})) return Ok{};
  return Error{
      ErrorCode::resource_exhausted,
      "the server has " + std::to_string(backend_.puts.max_jobs()) + " uploads to store already",
      {},
      {},
      {}};
}

void PutCall::store() {
  if (state_.is_over()) return refuse(cancelled());
  const auto result = backend_.materials.put(upload_.name(), upload_.take_content(), upload_.sum());
  if (!result) return refuse(result.error());
  response_ = wire::to_buffer(to_wire(upload_.name(), *result));
  end(grpc::Status::OK);
}

void PutCall::refuse(const Error& error) {
  access_.failed = 1;
  // What has a bound is too large at any time; memory and queue are full for a moment.
  if (error.code == ErrorCode::resource_exhausted && error.allowed.empty())
    context_.AddTrailingMetadata(wire::kRetryPushback, kPutPushbackMilliseconds);
  end(wire::to_status(error));
}

void PutCall::end(const grpc::Status& status) {
  access_.write(backend_.logger, status.ok() ? "OK" : status.error_message());
  happens_before(this);
  Finish(status);  // may delete this
}

void PutCall::OnCancel() {
  const Reaction reaction(this, &state_);
  state_.cancel();
  backend_.puts.drop_over();
}

void PutCall::OnDone() {
  happens_after(this);
  const Backend& backend = backend_;
  delete this;
  backend.call_ends();
}

}  // namespace gonio::server

// One PutMaterial call: reads the file's chunks, checks them, has them stored in the background,
// answers. It deletes itself when gRPC is done with it. Thread safety: its steps follow each other.
#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <utility>

#include "gonio/measured/table.h"
#include "server/calls/call.h"
#include "server/calls/failure.h"
#include "server/calls/start_calls.h"
#include "server/calls/upload.h"
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

class PutCall final : public grpc::ServerReadReactor<grpc::ByteBuffer> {
 public:
  static PutCall* start(const Backend& backend, grpc::CallbackServerContext& context,
                        grpc::ByteBuffer& response);

 private:
  PutCall(const Backend& backend, grpc::CallbackServerContext& context, grpc::ByteBuffer& response);
  void OnReadDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

  void read();
  void finish();
  Outcome take();
  Outcome queue_storing();
  void store();
  void refuse(const Error& error);
  void fail(const std::exception_ptr& failure) noexcept;
  void end(grpc::Status status);

  const Backend& backend_;
  grpc::CallbackServerContext& context_;
  grpc::ByteBuffer& response_;
  CallState state_;
  AccessLine access_;
  Upload upload_;
  grpc::ByteBuffer incoming_;
};

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
  try {
    if (!ok) return finish();
    if (auto taken = take(); !taken) return refuse(taken.error());
  } catch (...) {
    return fail(std::current_exception());
  }
  read();
}

void PutCall::finish() {
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
  BackgroundQueue::Job job{[this] { store(); }, [this] { return state_.is_over(); },
                           [this](const std::exception_ptr& failure) { fail(failure); }};
  if (backend_.puts.submit(std::move(job))) return Ok{};
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

void PutCall::fail(const std::exception_ptr& failure) noexcept {
  access_.failed = 1;
  end(status_of_failure(access_.method, failure, backend_.logger));
}

// Throws only before gRPC has been told of the end.
void PutCall::end(grpc::Status status) {
  access_.write(backend_.logger, status);
  happens_before(this);
  Finish(std::move(status));  // may delete this
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

}  // namespace

UploadReactor* start_put(const Backend& backend, grpc::CallbackServerContext& context,
                         grpc::ByteBuffer& response) {
  return PutCall::start(backend, context, response);
}

}  // namespace gonio::server

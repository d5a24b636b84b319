// A program of someone else's that asks a server, and itself, and compares: client_consumer ADDRESS
#include <gonio/client/client.h>
#include <gonio/engine/evaluate.h>

#include <cstdio>
#include <vector>

namespace {

const std::vector<float> kWi = {0, 0, 1, 0.6f, 0, 0.8f}, kWo = {0, 0.6f, 0.8f, -0.6f, 0, 0.8f};

std::vector<float> ask_server(const char* address) {
  const auto client = gonio::client::Client::connect(
      address, {.deadline = std::chrono::seconds(30), .max_retries = 8});
  if (!client.ok()) return std::puts(client.error().message.c_str()), std::vector<float>{};
  const auto gold = gonio::client::Material::model(
      "ggx", {{"f0", std::vector{1.0, 0.71, 0.29}}, {"alpha_x", 0.2}, {"alpha_y", 0.3}});
  std::vector<float> values(6);
  const auto report = client->evaluate(gold, kWi, kWo, values);
  if (!report.ok()) return std::puts(report.error().message.c_str()), std::vector<float>{};
  return values;
}

std::vector<float> ask_self() {
  const gonio::LobeSpec gold{"ggx",
                             {{"f0", std::vector{1.0, 0.71, 0.29}},
                              {"alpha_x", std::vector{0.2}},
                              {"alpha_y", std::vector{0.3}}}};
  const auto material = gonio::Material::create({.model = gold});
  if (!material.ok()) return std::puts(material.error().message.c_str()), std::vector<float>{};
  std::vector<float> values(6);
  gonio::Batch<float, float> batch;
  batch.wi = gonio::Directions<float>::interleaved(kWi.data());
  batch.wo = gonio::Directions<float>::interleaved(kWo.data());
  batch.count = 2;
  batch.values = gonio::Values<float>::interleaved(values.data(), 3);
  gonio::evaluate(*material, batch, gonio::best_isa());
  return values;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::puts("usage: client_consumer ADDRESS"), 2;
  const auto there = ask_server(argv[1]), here = ask_self();
  if (there.empty() || there != here) return std::puts("server and core differ"), 1;
  for (const float f : here) {
    if (!(f > 0)) return std::puts("a value is not positive"), 1;
  }
  std::printf("server and core agree: %g %g %g ...\n", here[0], here[1], here[2]);
}

// The library in one page: reads a domain, meshes it, prints its figures and writes the mesh.
//
//     mesh_domain assets/domains/step.json step.vtu
//
// Nothing here throws for a wrong input: what can fail returns a Result, which holds a value or an Error that says what
// is wrong, where, and what to do about it.
#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "core/domain/read.h"
#include "core/io/export.h"
#include "core/io/write_mesh.h"
#include "core/method/pipeline.h"
#include "core/quality/quality.h"

namespace {

int fail(const triscope::Error& error) {
  fmt::print(stderr, "{}\n", triscope::describe(error));
  return EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace triscope;
  if (argc != 3) return fail({.kind = ErrorKind::usage, .message = "usage: mesh_domain DOMAIN.json MESH.vtu"});

  Result<Domain> domain = readDomain(argv[1]);
  if (!domain) return fail(domain.error());

  Settings settings;  // the standard ones, optimised; core/words/settings.h says what can be set
  settings.omega = 0.1;

  // The state is a value: a copy of it, at any moment, can be carried on by itself.
  Result<MeshState> state = begin(std::make_shared<const Domain>(std::move(*domain)), settings);
  if (!state) return fail(state.error());
  Journal nobody;  // Journal{&events} would keep every decision and its reason
  while (advance(*state, Grain::stage, nobody)) fmt::print("{}\n", infoOf(state->stage).name);
  if (state->failed) return fail({.message = "the method could not mesh this domain"});

  const Quality quality = measure(state->mesh);
  fmt::print("{} triangles, {} vertices, angles from {:.1f} to {:.1f} degrees, worst aspect ratio {:.2f}\n",
             quality.triangles, quality.vertices, quality.minAngle, quality.maxAngle, quality.aspectMax);

  const Status written = writeMesh(argv[2], exportMesh(*state));
  return written ? 0 : fail(written.error());
}

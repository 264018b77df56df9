#include "app/commands.h"

#include <iostream>
#include <memory>

#include "app/info_command.h"
#include "app/picture_size.h"
#include "app/render_command.h"
#include "app/serve_options.h"
#include "app/terminal_progress.h"
#include "core/process.h"
#include "render/render_settings.h"

#ifdef CUTAWAY_IMPORT
#include "import/isolation/import_worker.h"
#include "import/isolation/isolated_reader.h"
#endif

namespace cutaway {

namespace {

/// A complaint, as CLI11 wants it; empty where the text is right.
std::string valid_size(const std::string& text) try {
  parse_picture_size(text);
  return "";
} catch (const Error& error) {
  return error.what();
}

std::string named(const std::string& path) { return path.empty() ? "the path is empty" : ""; }

void add_render(CLI::App& app) {
  const auto command = std::make_shared<RenderCommand>();
  CLI::App* render =
      app.add_subcommand("render", "Renders one picture of a scene or style document");
  render->add_option("scene", command->scene_path, "Scene or style document (JSON)")->required();
  render->add_option("-o,--output", command->output_path, "PNG to write")->required();
  render
      ->add_option("--volume", command->volume,
                   "phantom:NAME[@SIZE], a file or a folder; PATH#ID for one of several")
      ->check(named);
  render
      ->add_option(
          "--size",
          [command](const CLI::results_t& words) {
            command->size = parse_picture_size(words.at(0));
            return true;
          },
          "Picture size in pixels")
      ->type_name("WIDTHxHEIGHT")
      ->check(valid_size);
  render->add_option("--supersampling", command->supersampling, "Rays a pixel each way")
      ->check(CLI::Range(1, kMostSupersampling))
      ->capture_default_str();
  render->add_flag("--require-gpu", command->require_gpu, "Refuse software rendering");
  render->callback([command] {
    forbid_core_dumps();
    run_render(*command);
  });
}

InfoReaders file_readers() {
#ifdef CUTAWAY_IMPORT
  return {.scan = [](const auto& path,
                     const auto& root) { return scan_volumes_isolated({}, path, root, {}, {}); },
          .read =
              [](const VolumeSource& source) {
                return read_volume_isolated({}, source, {}, terminal_progress(), {});
              }};
#else
  return {};
#endif
}

void add_info(CLI::App& app) {
  const auto request = std::make_shared<InfoRequest>();
  CLI::App* info = app.add_subcommand("info", "Says what a file or folder holds");
  info->add_option("path", request->path, "A file, a folder or phantom:NAME")
      ->required()
      ->check(named);
  info->add_flag("--json", request->as_json, "One JSON object");
  info->callback([request] {
    forbid_core_dumps();
    const int status = run_info(*request, file_readers(), std::cout, std::cerr);
    if (status != 0) throw CLI::RuntimeError(status);
  });
}

/// Not for people: the program starts itself so to read a file in a process of its own.
void add_import_worker([[maybe_unused]] CLI::App& app) {
#ifdef CUTAWAY_IMPORT
  CLI::App* worker = app.add_subcommand("read-volume-worker")->group("");
  worker->callback([] { throw CLI::RuntimeError(run_import_worker()); });
#endif
}

}  // namespace

void add_commands(CLI::App& app) {
  add_serve(app);
  add_info(app);
  add_render(app);
  add_import_worker(app);
}

}  // namespace cutaway

#include "app/serve_options.h"

#include <memory>
#include <optional>

#include "core/error.h"

namespace cutaway {

namespace {

struct ServeOptions {
  std::vector<std::string> data;
  std::optional<std::string> listen;
  std::optional<std::string> config;
  std::optional<std::string> web_root;
  bool require_gpu = false;
};

/// A complaint, as CLI11 wants it; empty where the text is right.
std::string valid_listen(const std::string& text) try {
  NetSettings unused;
  parse_listen(text, unused);
  return "";
} catch (const Error& error) {
  return error.what();
}

Config config_from(const ServeOptions& options) {
  Config config;
  if (options.config) read_config_file(*options.config, config);
  if (options.listen) parse_listen(*options.listen, config.net);
  if (options.web_root) config.net.web_root = *options.web_root;
  if (!options.data.empty()) config.volumes.data.assign(options.data.begin(), options.data.end());
  config.renderer.require_gpu = config.renderer.require_gpu || options.require_gpu;
  return config;
}

}  // namespace

void add_serve(CLI::App& app) {
  const auto options = std::make_shared<ServeOptions>();
  CLI::App* serve = app.add_subcommand("serve", "Serves volumes to browsers until it is stopped");
  serve->add_option("--data", options->data, "Folder or file with volumes; may be given again")
      ->type_name("DIR")
      ->take_all();
  serve
      ->add_option("--listen", options->listen,
                   "Where to listen; port 0 picks a free one [127.0.0.1:8080]")
      ->type_name("ADDRESS:PORT")
      ->check(valid_listen);
  serve->add_option("--config", options->config, "Configuration file (TOML)")->type_name("FILE");
  serve->add_option("--web-root", options->web_root, "Folder of the built web client")
      ->type_name("DIR");
  serve->add_flag("--require-gpu", options->require_gpu, "Refuse software rendering");
  serve->callback([options] { run_serve(config_from(*options)); });
}

}  // namespace cutaway

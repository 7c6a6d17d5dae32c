// `ribalta view`: the window.
#pragma once

namespace CLI {
class App;
}

namespace ribalta {

/// Adds the subcommand to `app`.
void addViewCommand(CLI::App& app);

}  // namespace ribalta

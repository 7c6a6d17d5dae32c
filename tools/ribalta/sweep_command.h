// `ribalta sweep`: run time against error, measured.
#pragma once

namespace CLI {
class App;
}

namespace ribalta {

void addSweepCommand(CLI::App& app);

}  // namespace ribalta

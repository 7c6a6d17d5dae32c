// `ribalta compare`: how far two pictures are apart.
#pragma once

namespace CLI {
class App;
}

namespace ribalta {

void addCompareCommand(CLI::App& app);

}  // namespace ribalta

// `ribalta reference`: the slow, exact answer that drawn frames are measured against.
#pragma once

namespace CLI {
class App;
}

namespace ribalta {

void addReferenceCommand(CLI::App& app);

}  // namespace ribalta

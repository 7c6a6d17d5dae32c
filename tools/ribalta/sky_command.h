// `ribalta sky`: what a model of the sky says of listed rays, as numbers.
#pragma once

namespace CLI {
class App;
}

namespace ribalta {

void addSkyCommand(CLI::App& app);

}  // namespace ribalta

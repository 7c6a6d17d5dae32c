// Every model of a folder of other people's glTF files: the valid ones load, those that bend a rule
// load, the broken ones are refused with a place or reported; none crashes, hangs or yields a scene
// that breaks its own promises. The folder is not part of the project: RIBALTA_GLTF_ASSETS, or
// ../shared/assets/gltf beside the checkout, with a manifest.csv. RIBALTA_CORPUS_TABLE names a file
// to which what became of each model is written.
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "gltf/load_gltf.h"
#include "support/scene_faults.h"

namespace ribalta {
namespace {

// A load may take this long, sanitizers included. Work is counted in processor time, so that a busy
// machine or a cold disk is no fault of the loader; what hangs without working is waited for
// longer.
constexpr std::chrono::seconds kProcessorTimeLimit(30);
constexpr std::chrono::seconds kWaitLimit(300);

std::filesystem::path assetsFolder() {
    const char* given = std::getenv("RIBALTA_GLTF_ASSETS");
    return given != nullptr ? std::filesystem::path(given)
                            : std::filesystem::path(RIBALTA_SOURCE_DIR) / "../shared/assets/gltf";
}

// One line of comma-separated values, quoted where they hold commas.
std::vector<std::string> splitCsv(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            cells.emplace_back();
        } else if (c != '\r') {
            cells.back() += c;
        }
    }
    return cells;
}

struct Model {
    std::string path;
    std::string kind;  // valid, tolerate, broken
};

std::vector<Model> modelsOfKind(const std::filesystem::path& folder, const std::string& kind) {
    std::ifstream manifest(folder / "manifest.csv");
    std::string line;
    std::getline(manifest, line);
    std::map<std::string, std::size_t> column;
    for (const std::string& name : splitCsv(line)) {
        column.emplace(name, column.size());
    }
    std::vector<Model> models;
    while (std::getline(manifest, line)) {
        const std::vector<std::string> cells = splitCsv(line);
        if (cells.size() > column.at("cls") && cells[column.at("kind")] == "model" &&
            cells[column.at("cls")] == kind) {
            models.push_back({cells[column.at("path")], kind});
        }
    }
    return models;
}

// Processor time of all threads of this program since it started.
std::chrono::duration<double> processorTime() {
    return std::chrono::duration<double>(double(std::clock()) / CLOCKS_PER_SEC);
}

// Ends the program, naming the file, when a load does not return.
class Watchdog {
  public:
    explicit Watchdog(std::string file) : file_(std::move(file)), thread_([this] { watch(); }) {}
    ~Watchdog() {
        {
            const std::scoped_lock lock(mutex_);
            done_ = true;
        }
        changed_.notify_all();
    }
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

  private:
    void watch() {
        const auto start = processorTime();
        std::unique_lock lock(mutex_);
        for (std::chrono::seconds waited(0);
             !changed_.wait_for(lock, std::chrono::seconds(1), [this] { return done_; });
             ++waited) {
            const auto worked = processorTime() - start;
            if (worked > kProcessorTimeLimit || waited > kWaitLimit) {
                std::cerr << file_ << ": still loading after " << waited.count() << " s, "
                          << worked.count() << " s of processor time\n";
                std::abort();
            }
        }
    }

    std::string file_;
    bool done_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::jthread thread_;  // last: uses all of the above
};

struct Outcome {
    bool loaded = false;
    bool hasPlace = false;  // of the error
    std::string message;    // of the error
    std::vector<std::string> report;
    std::vector<std::string> faults;
};

Outcome load(const std::filesystem::path& path) {
    const Watchdog watchdog(path.string());
    Outcome outcome;
    try {
        const LoadedScene result = loadGltf(path);
        outcome.loaded = true;
        outcome.faults = test::sceneFaults(result.scene);
        for (const Report::Entry& entry : result.report.entries()) {
            EXPECT_FALSE(entry.message.empty());
            outcome.report.push_back(std::string(name(entry.kind)) + " " + entry.place.pointer +
                                     ": " + entry.message);
        }
    } catch (const Error& error) {
        outcome.message = error.what();
        outcome.hasPlace = !error.place().file.empty() && error.kind() == ErrorKind::kBadInput;
    }
    return outcome;
}

// Loads every model of a kind, writes the table and hands each outcome to `judge`.
template <typename Judge>
void forEachModel(const std::string& kind, const Judge& judge) {
    const std::filesystem::path folder = assetsFolder();
    if (!std::filesystem::exists(folder / "manifest.csv")) {
        GTEST_SKIP() << "no models in " << folder << "; set RIBALTA_GLTF_ASSETS";
    }
    const char* tablePath = std::getenv("RIBALTA_CORPUS_TABLE");
    std::ofstream table;
    if (tablePath != nullptr) {
        table.open(tablePath, std::ios::app);
    }
    const std::vector<Model> models = modelsOfKind(folder, kind);
    EXPECT_FALSE(models.empty());
    for (const Model& model : models) {
        SCOPED_TRACE((folder / model.path).string());
        table << kind << '\t' << model.path << '\t' << std::flush;
        const Outcome outcome = load(folder / model.path);
        table << (outcome.loaded ? "loaded" : "refused") << '\t' << outcome.message;
        for (const std::string& line : outcome.report) {
            table << line << " | ";
        }
        table << std::endl;
        for (const std::string& fault : outcome.faults) {
            ADD_FAILURE() << fault;
        }
        judge(outcome);
    }
}

// The only good reason to refuse a valid model: it requires what is not supported.
bool isUnsupportedExtension(const Outcome& outcome) {
    return outcome.hasPlace && outcome.message.find("/extensionsRequired/") != std::string::npos;
}

TEST(GltfCorpusTest, ValidModelsLoad) {
    forEachModel("valid", [](const Outcome& outcome) {
        EXPECT_TRUE(outcome.loaded || isUnsupportedExtension(outcome)) << outcome.message;
    });
}

TEST(GltfCorpusTest, ModelsThatBendARuleLoad) {
    forEachModel("tolerate",
                 [](const Outcome& outcome) { EXPECT_TRUE(outcome.loaded) << outcome.message; });
}

TEST(GltfCorpusTest, BrokenModelsAreRefusedOrReported) {
    forEachModel("broken", [](const Outcome& outcome) {
        if (outcome.loaded) {
            EXPECT_FALSE(outcome.report.empty()) << "loaded without a word";
        } else {
            EXPECT_TRUE(outcome.hasPlace) << outcome.message;
        }
    });
}

}  // namespace
}  // namespace ribalta

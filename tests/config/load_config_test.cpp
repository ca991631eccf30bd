// SPDX-License-Identifier: MIT
#include "daemon/config/load_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "base/keys/json_text.h"
#include "daemon/config/keys/config_keys.h"
#include "daemon/config/keys/device_keys.h"
#include "tests/config/fake_files.h"
#include "tests/folders.h"

namespace hedgehog::config {
namespace {

std::string shipped(const std::string& name) {
  const auto text = read_file(source_folder() + "/config/" + name);
  EXPECT_EQ(text.problem, "") << name;
  return text.text;
}

void collect_paths(const keys::Value& section, const std::string& prefix,
                   std::set<std::string>& paths) {
  for (std::size_t i = 0; i < section.keys.size(); ++i) {
    const std::string path = prefix + section.keys[i];
    if (section.elements[i].kind == keys::Value::Kind::kObject)
      collect_paths(section.elements[i], path + ".", paths);
    else
      paths.insert(path);
  }
}

std::set<std::string> paths_in(const std::string& text) {
  const auto root = keys::parse_json(text, "shipped");
  EXPECT_TRUE(root.has_value());
  std::set<std::string> paths;
  if (root) collect_paths(*root, "", paths);
  return paths;
}

template <class Target>
std::set<std::string> paths_of(const std::vector<keys::Key<Target>>& keys) {
  std::set<std::string> paths;
  for (const auto& key : keys) paths.insert(key.path);
  return paths;
}

TEST(LoadConfig, WithoutFilesTheBackendIsTheSimulatorByDefault) {
  const auto config = FakeFiles{}.load();
  ASSERT_TRUE(config.has_value());
  EXPECT_EQ(config->backend, Backend::kSimulator);
  EXPECT_FALSE(config->configured);
  EXPECT_THAT(config->files, testing::IsEmpty());
  EXPECT_EQ(config->listen.tcp, (std::vector<ListenAddress>{{"127.0.0.1", 7586}, {"::1", 7586}}));
  EXPECT_EQ(config->listen.unix_socket, "/run/hedgehog/hedgehogd.sock");
  EXPECT_EQ(config->http.listen, (ListenAddress{"127.0.0.1", 7587}));
  EXPECT_EQ(config->limits, model::Limits{});
  EXPECT_EQ(config->imu, ImuType::kSimulator);
  EXPECT_EQ(config->state_directory, "/var/lib/hedgehog");
}

TEST(LoadConfig, TheShippedFilesDocumentEveryKeyAndChangeNothing) {
  FakeFiles fake;
  const std::string built_in = print_config(*fake.load());
  const std::string built_in_device = print_device(fake.load()->device);
  fake.files["/usr/share/hedgehog/hedgehogd.json"] = shipped("hedgehogd.json");
  fake.files["/usr/share/hedgehog/devices.d/hedgehog-86.json"] =
      shipped("devices.d/hedgehog-86.json");
  EXPECT_EQ(fake.errors(), "");
  EXPECT_EQ(print_config(*fake.load()), built_in);
  EXPECT_EQ(print_device(fake.load()->device), built_in_device);
  EXPECT_EQ(fake.load()->files.size(), 2u);
  EXPECT_FALSE(fake.load()->configured);
  EXPECT_EQ(paths_in(shipped("hedgehogd.json")), paths_of(config_keys()));
  EXPECT_EQ(paths_in(shipped("devices.d/hedgehog-86.json")), paths_of(device_keys()));
}

// Every key of the documented file, each with a value other than its default.
constexpr const char* kOtherKeys = R"({
  "backend": "simulator", "device": "mine", "arm_at_start": "never",
  "limits": {"current_a": 12, "continuous_a": 4.5, "felt_a": 2, "derate_from_c": 50,
             "sustain_c": 60, "zero_c": 62, "trip_c": 65, "rearm_c": 40},
  "output": {"gain": 0.5},
  "imu": {"type": "external", "serial": "0368248C", "front": "left", "up": "down"},
  "thermometer": {"type": "temper", "role": "shell", "serial": "7"},
  "listen": {"tcp": ["127.0.0.2:0"], "unix": "/tmp/ball.sock"},
  "http": {"listen": null, "allow_origins": ["https://game.example:8443"], "pages": "/srv/www"},
  "access": {"tokens": "/srv/tokens", "certificate": "/srv/cert.pem", "key": "/srv/cert.key",
             "unix": {"operate": ["root", "@0"], "play": ["@root"], "observe": ["*"]}},
  "connections": {"max": 8, "queue_bytes": 262144, "write_timeout_s": 3, "io_uring_after": 3},
  "telemetry": {"max_rate_hz": 50},
  "log": {"level": "debug"}, "state_directory": "/srv/state", "runtime_directory": "/srv/run",
  "simulator": {"ambient_c": 18, "start_temperature_c": 53, "process": true, "seed": 4294967295,
                "device": "truth", "front_end": "driver_cs", "thermistors": 3}
})";

FakeFiles other_keys() {
  FakeFiles fake = FakeFiles::with(kOtherKeys);
  fake.files["/etc/hedgehog/devices.d/mine.json"] = R"({"name": "ball-7"})";
  fake.files["/usr/share/hedgehog/devices.d/truth.json"] = R"({"r25_ohm": [0.5, 0.4, 0.6]})";
  return fake;
}

TEST(LoadConfig, EveryKeyIsLoaded) {
  ASSERT_EQ(paths_in(kOtherKeys), paths_of(config_keys()));
  ASSERT_EQ(other_keys().errors(), "");
  const Config c = *other_keys().load();
  EXPECT_TRUE(c.configured);
  EXPECT_EQ(c.device_file, "mine");
  EXPECT_EQ(c.device.name, "ball-7");
  EXPECT_EQ(c.arm_at_start, ArmAtStart::kNever);
  EXPECT_EQ(c.limits, (model::Limits{12, 4.5, 2, 50, 60, 62, 65, 40}));
  EXPECT_EQ(c.gain, 0.5);
  EXPECT_EQ(c.imu, ImuType::kExternal);
  EXPECT_EQ(c.imu_fitting, (ImuFitting{"0368248C", device::Side::kLeft, device::Side::kDown}));
  EXPECT_EQ(c.thermometer,
            (ThermometerSettings{&device::kTemperDriver, device::ThermometerRole::kShell, "7"}));
  EXPECT_EQ(c.listen, (ListenSettings{{{"127.0.0.2", 0}}, "/tmp/ball.sock"}));
  EXPECT_EQ(c.http, (HttpSettings{std::nullopt, {"https://game.example:8443"}, "/srv/www"}));
  using enum access::Principal::Kind;
  const access::UnixRoles roles{
      {{}}, {{kGroup, 0, "@root"}}, {{kUser, 0, "root"}, {kGroup, 0, "@0"}}};
  EXPECT_EQ(c.access,
            (AccessSettings{"/srv/tokens", "/srv/cert.pem", "/srv/cert.key", {}, "", "", roles}));
  EXPECT_EQ(c.connections, (ConnectionSettings{8, 262144, 3, 3}));
  EXPECT_EQ(c.telemetry_max_rate_hz, 50);
  EXPECT_EQ(c.log_level, LogLevel::kDebug);
  EXPECT_EQ(c.state_directory, "/srv/state");
  EXPECT_EQ(c.runtime_directory, "/srv/run");
  model::DeviceModel true_device;
  true_device.coils.r25_ohm = {0.5, 0.4, 0.6};
  EXPECT_EQ(c.simulator, (SimulatorSettings{18, 53, true, device::FrontEndKind::kDriverCs, 3,
                                            4294967295u, "truth", true_device}));
}

TEST(LoadConfig, ThePrintedConfigurationLoadsBackUnchanged) {
  FakeFiles fake = other_keys();
  const std::string printed = print_config(*fake.load());
  EXPECT_EQ(paths_in(printed), paths_of(config_keys()));
  fake.files["/etc/hedgehog/hedgehogd.json"] = printed;
  ASSERT_EQ(fake.errors(), "");
  EXPECT_EQ(print_config(*fake.load()), printed);
  EXPECT_EQ(fake.load()->listen.unix_socket, "/tmp/ball.sock");
  EXPECT_EQ(fake.load()->limits, other_keys().load()->limits);
}

TEST(LoadConfig, LaterLayersWinKeyByKey) {
  FakeFiles fake = FakeFiles::with(R"({"simulator": {"seed": 3}, "log": {"level": "error"}})");
  fake.files[fake.paths.defaults_file] = R"({"simulator": {"seed": 2, "ambient_c": 19}})";
  fake.overrides.log_level = "debug";
  const Config c = *fake.load();
  EXPECT_EQ(c.simulator.seed, 3u);
  EXPECT_EQ(c.simulator.ambient_c, 19);
  EXPECT_EQ(c.log_level, LogLevel::kDebug);
  EXPECT_THAT(c.files, testing::ElementsAre(fake.paths.defaults_file, fake.paths.config_file));
}

TEST(LoadConfig, SimulateAndListenOverrideTheFiles) {
  FakeFiles fake = FakeFiles::with(R"({"backend": "usb"})");
  EXPECT_EQ(fake.load()->backend, Backend::kUsb);
  EXPECT_EQ(fake.load()->imu, ImuType::kNone);
  fake.overrides.simulate = true;
  fake.overrides.listen = {"127.0.0.1:0"};
  EXPECT_EQ(fake.load()->backend, Backend::kSimulator);
  EXPECT_EQ(fake.load()->imu, ImuType::kSimulator);
  EXPECT_EQ(fake.load()->listen.tcp, (std::vector<ListenAddress>{{"127.0.0.1", 0}}));
  EXPECT_EQ(fake.load()->http.listen, (ListenAddress{"127.0.0.1", 0}));
}

TEST(LoadConfig, ListenLeavesAConfiguredHttpListenerAlone) {
  FakeFiles fake = FakeFiles::with(R"({"http": {"listen": "127.0.0.1:8080"}})");
  fake.overrides.listen = {"127.0.0.1:0"};
  EXPECT_EQ(fake.load()->http.listen, (ListenAddress{"127.0.0.1", 8080}));
  // An address in the defaults file is not an explicit setting.
  fake.files[fake.paths.defaults_file] = fake.files[fake.paths.config_file];
  fake.files.erase(fake.paths.config_file);
  EXPECT_EQ(fake.load()->http.listen, (ListenAddress{"127.0.0.1", 0}));
}

TEST(LoadConfig, WrongOptionsNameTheOption) {
  FakeFiles fake;
  fake.overrides.listen = {"127.0.0.1:0", "8080"};
  fake.overrides.log_level = "loud";
  EXPECT_EQ(fake.errors(),
            "--listen: \"8080\": must be an address and a port, such as 127.0.0.1:7586 or "
            "[::1]:7586\n"
            "--log-level: must be \"debug\", \"info\", \"warning\" or \"error\", not \"loud\"\n");
}

TEST(LoadConfig, AFileGivenByOptionMustExist) {
  FakeFiles fake;
  fake.paths.config_file = "/nowhere.json";
  fake.paths.config_file_required = true;
  EXPECT_EQ(fake.errors(), "/nowhere.json: No such file or directory\n");
}

TEST(LoadConfig, DeviceFilesAreSearchedBesideTheConfigurationFirst) {
  FakeFiles fake = FakeFiles::with(R"({"device": "mine"})");
  EXPECT_EQ(fake.errors(),
            "/etc/hedgehog/hedgehogd.json:1: device: there is no "
            "/etc/hedgehog/devices.d/mine.json or /usr/share/hedgehog/devices.d/mine.json\n");
  fake.files["/usr/share/hedgehog/devices.d/mine.json"] = R"({"name": "theirs"})";
  EXPECT_EQ(fake.load()->device.name, "theirs");
  fake.files["/etc/hedgehog/devices.d/mine.json"] = R"({"name": "ours"})";
  EXPECT_EQ(fake.load()->device.name, "ours");
  fake.files["/etc/hedgehog/hedgehogd.json"] = R"({"device": "../balls/mine.json"})";
  fake.files["/etc/balls/mine.json"] = R"({"name": "elsewhere"})";
  EXPECT_EQ(fake.load()->device.name, "elsewhere");
}

TEST(LoadConfig, ReadFileDistinguishesMissingFromUnreadable) {
  EXPECT_TRUE(read_file("/nowhere/at/all").missing);
  EXPECT_FALSE(read_file("/").missing);
  EXPECT_EQ(read_file("/").problem, "is a folder, not a regular file");
  EXPECT_EQ(read_file("/dev/zero").problem, "is a device, not a regular file");
}

// A configuration that is nearly valid: known keys with values of any kind.
rc::Gen<std::string> any_json(int depth) {
  auto leaf = rc::gen::element<std::string>(
      "null", "true", "-1", "0", "1", "15", "1e300", "0.5", "\"usb\"", "\"\"", "\"/x\"",
      "\"127.0.0.1:1\"", "\"\\u0000\"", "[]", "{}", "[[[1]]]", "NaN", "'", "\xff", "// c\n1");
  if (depth == 0) return leaf;
  const auto key = rc::gen::element<std::string>(
      "backend", "device", "limits", "current_a", "listen", "tcp", "unix", "http", "simulator",
      "seed", "imu", "type", "", ".", "limits.current_a", "curent_a", "coil_matrix", "usb");
  const auto member = rc::gen::map(rc::gen::pair(key, any_json(depth - 1)),
                                   [](auto kv) { return '"' + kv.first + "\":" + kv.second; });
  return rc::gen::oneOf(
      leaf, rc::gen::map(rc::gen::container<std::vector<std::string>>(member), [](auto members) {
        std::string text = "{";
        for (const auto& m : members) text += (text.size() > 1 ? ",\n" : "") + m;
        return text + "}";
      }));
}

RC_GTEST_PROP(LoadConfig, ArbitraryTextIsHandledAndEveryErrorNamesItsFile, ()) {
  const std::string text = *rc::gen::oneOf(any_json(3), rc::gen::arbitrary<std::string>());
  for (const FakeFiles& fake : {FakeFiles::with(text), FakeFiles::with_device(text)}) {
    const auto loaded = fake.load();
    if (loaded) {
      RC_ASSERT(model::is_within(loaded->limits, loaded->device.limits));
      continue;
    }
    RC_ASSERT(!loaded.error().empty());
    for (const keys::FileError& error : loaded.error()) {
      RC_ASSERT(error.file.starts_with("/etc/hedgehog/"));
      RC_ASSERT(!error.reason.empty());
    }
  }
}

TEST(Sensors, AreReadAndPrinted) {
  const FakeFiles fake = FakeFiles::with(R"({
    "backend": "usb",
    "imu": {"type": "dualsense", "serial": "aa:bb", "front": "left", "up": "down"},
    "thermometer": {"type": "temper", "role": "shell"}
  })");
  const auto config = fake.load();
  ASSERT_TRUE(config) << to_string(config.error());
  EXPECT_EQ(config->imu, &device::kDualSenseDriver);
  EXPECT_EQ(config->imu_fitting, (ImuFitting{"aa:bb", device::Side::kLeft, device::Side::kDown}));
  EXPECT_EQ(config->thermometer.driver, &device::kTemperDriver);
  EXPECT_EQ(config->thermometer.role, device::ThermometerRole::kShell);
  const auto again = FakeFiles::with(print_config(*config)).load();
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(again->imu_fitting, config->imu_fitting);
  EXPECT_EQ(again->thermometer, config->thermometer);
  EXPECT_EQ(name(again->imu), "dualsense");
}

TEST(Sensors, NoRealThermometerChecksASimulatedCoil) {
  FakeFiles fake =
      FakeFiles::with(R"({"backend": "usb", "thermometer": {"type": "temper", "role": "coil"}})");
  EXPECT_EQ(fake.load()->thermometer.role, device::ThermometerRole::kCoil);
  fake.overrides.simulate = true;
  EXPECT_EQ(fake.load()->thermometer, ThermometerSettings{});
}

TEST(Sensors, ContradictionsAreNamed) {
  const auto error_of = [](const std::string& text) {
    const auto config = FakeFiles::with(text).load();
    return config ? std::string("none") : to_string(config.error());
  };
  using testing::HasSubstr;
  EXPECT_THAT(error_of(R"({"imu": {"front": "left", "up": "right"}})"),
              HasSubstr("imu.up: must be neither the side of imu.front nor the opposite one"));
  EXPECT_THAT(error_of(R"({"thermometer": {"type": "temper"}})"),
              HasSubstr("thermometer.role: must be \"coil\" or \"shell\""));
  EXPECT_THAT(error_of(R"({"thermometer": {"role": "shell"}})"),
              HasSubstr("thermometer.role: needs a thermometer"));
  EXPECT_THAT(error_of(R"({"imu": {"type": "mtw"}})"), HasSubstr("\"dualshock4\" or \"mti\""));
  EXPECT_THAT(error_of(R"({"imu": {"serial": ""}})"), HasSubstr("a serial number or null"));
}

}  // namespace
}  // namespace hedgehog::config

// SPDX-License-Identifier: MIT
// Errors injected into the simulated board: their effect, and their transmission.
#include "daemon/device/simulator/simulator_errors.h"

#include <gtest/gtest.h>

#include "daemon/device/link.h"
#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::device {
namespace {

SimulatorErrorList list_of(std::initializer_list<SimulatorError> errors) {
  SimulatorErrorList list;
  for (const SimulatorError& error : errors) list.error[list.count++] = error;
  return list;
}

TEST(SimulatorErrors, ActAtOnceOrGrowLinearly) {
  SimulatorErrors errors;
  errors.set(list_of({{SimulatorErrorKind::kCurrentGain, 1, 1.10, 0.0},
                      {SimulatorErrorKind::kSupplyGain, 0, 0.9, 0.1}}));
  const FrontEndParameters built = FrontEndChoice{}.parameters();
  EXPECT_NEAR(errors.on(built).current_gain[1], 1.10, 1e-6);
  EXPECT_EQ(errors.on(built).current_gain[0], 1.0);
  EXPECT_NEAR(errors.on(built).supply_gain, 1.0, 1e-6);
  for (int ms = 0; ms < 50; ++ms) errors.step();
  EXPECT_NEAR(errors.on(built).supply_gain, 0.95, 1e-6);
  for (int ms = 0; ms < 100; ++ms) errors.step();
  EXPECT_NEAR(errors.on(built).supply_gain, 0.9, 1e-6);
  EXPECT_FALSE(errors.step()) << "nothing grows any more";
  errors.set({});
  EXPECT_EQ(errors.on(built).supply_gain, 1.0);
}

TEST(SimulatorErrors, OfTheBallChangeThePlant) {
  SimulatorErrors errors;
  errors.set(list_of({{SimulatorErrorKind::kShortedTurns, 2, 0.1, 0.0},
                      {SimulatorErrorKind::kResistanceGain, 0, 0.95, 0.0},
                      {SimulatorErrorKind::kCoolingGain, 0, 0.5, 0.0}}));
  model::Plant plant;
  const double before = plant.resistance_ohm(0);
  plant.set_errors(errors.plant());
  EXPECT_NEAR(plant.resistance_ohm(0), 0.95 * before, 1e-6);
  EXPECT_NEAR(plant.resistance_ohm(2), 0.9 * before, 1e-6);
  EXPECT_NEAR(errors.plant().cooling_gain, 0.5, 1e-6);
}

TEST(SimulatorErrors, EveryKindHasANameAndARangeThatContainsNoError) {
  for (int k = 0; k < kSimulatorErrorKinds; ++k) {
    const auto kind = static_cast<SimulatorErrorKind>(k);
    EXPECT_EQ(simulator_error_kind(name(kind)), kind);
    const SimulatorErrorRange range = range_of(kind);
    EXPECT_LE(range.min, range.none);
    EXPECT_GT(range.max, range.none);
  }
  EXPECT_FALSE(simulator_error_kind("gremlins"));
}

// Frames of the list may be lost; the list takes effect once, when all of it has arrived.
TEST(SimulatorErrors, AreReceivedFrameByFrame) {
  const SimulatorErrorList list = list_of({{SimulatorErrorKind::kPwmStuck, 1, 0.3, 0.0},
                                           {SimulatorErrorKind::kTachGain, 0, 2.0, 60.0},
                                           {SimulatorErrorKind::kThermistorContact, 2, 1.0, 1.5}});
  SimulatorErrorReader reader;
  EXPECT_FALSE(reader.take(encode_simulator_error(list, 2, 1)));
  EXPECT_FALSE(reader.take(encode_simulator_error(list, 0, 2)));
  EXPECT_FALSE(reader.take(encode_simulator_error(list, 0, 3)));
  const auto whole = reader.take(encode_simulator_error(list, 1, 4));
  ASSERT_TRUE(whole);
  EXPECT_EQ(*whole, list);
  EXPECT_FALSE(reader.take(encode_simulator_error(list, 1, 5))) << "it acts already";
}

struct Pair {
  Link link;
  SimulatedBoard board;
  LinkCommand command;

  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      const LinkFrames frames = link.step(command);
      board.receive(frames.set_point);
      if (frames.other) board.receive(*frames.other);
      if (const auto telemetry = board.step()) link.receive(*telemetry);
      if (const auto truth = board.truth_frame()) link.receive(*truth);
    }
  }
};

TEST(SimulatorErrors, AreSentOverTheLinkAndTheTrueStateIsReturned) {
  Pair pair;
  SimulatorSettings settings;
  settings.ambient_c = 19.0;
  settings.errors = list_of({{SimulatorErrorKind::kThermistorOffsetK, 1, 5.0, 0.0},
                             {SimulatorErrorKind::kTachGain, 0, 0.5, 0.0}});
  pair.link.set_simulator(settings);
  pair.run(50);
  EXPECT_EQ(pair.board.settings(), settings);
  const BoardTelemetry& telemetry = pair.link.report().telemetry;
  EXPECT_NEAR(telemetry.thermistor[1].celsius, 30.0, 1.5);
  EXPECT_NEAR(telemetry.thermistor[2].celsius, 25.0, 1.5);
  ASSERT_TRUE(pair.link.truth().known);
  EXPECT_NEAR(pair.link.truth().coils_c[1], 25.0, 0.01);
  EXPECT_EQ(pair.link.truth().ambient_c, 19.0);
  pair.run(150);
  // The same list sent again grows from zero again.
  ++settings.errors.generation;
  pair.link.set_simulator(settings);
  pair.run(20);
  EXPECT_EQ(pair.board.settings(), settings);
  settings.errors = {};
  pair.link.set_simulator(settings);
  pair.run(20);
  EXPECT_EQ(pair.board.settings(), settings);
}

}  // namespace
}  // namespace hedgehog::device

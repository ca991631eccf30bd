// SPDX-License-Identifier: MIT
// The electrical rules: both boards comply with them, and each rule detects a netlist that violates it.
import assert from "node:assert/strict";
import { test } from "node:test";

import { kRules, violations } from "../../firmware/board/check.mjs";
import { readBoard } from "../../firmware/board/netlist.mjs";
import { restingLevel } from "../../firmware/board/rules_safe.mjs";
import { asBuilt, breaks, kTypes } from "./boards.mjs";

for (const name of ["reference", "thesis"])
  test(`the board ${name} breaks no rule`, () => {
    const board = readBoard(name);
    assert.ok(board.parts.size > 50);
    assert.deepEqual(violations(board, kTypes), []);
  });

const kBroken = {
  "a pin that is left out": [["connections"], /U2\.REF2 is not connected/, " REF2=GND OUT=IA ", " OUT=IA "],
  "a pin that is connected twice": [["connections"], /U2\.OUT is connected twice/, "OUT=IA ", "OUT=IA OUT=IB "],
  "a pin that there is not": [["connections"], /M1 \(G2_18V17\) has no pin BRAKE/, "VREF=VREF_A unused=VM", "VREF=VREF_A BRAKE=GND unused=VM"],
  "a part that stands twice": [["connections"], /board:\d+: R1 stands twice/, "", "", "\nR1 R 1k tol=1% power=0.25 : 1=IS 2=GND\n"],
  "a part that there is not": [["connections"], /no part type INA999/, "", "", "\nU9 INA999 : OUT=IA\n"],
  "a net that was not declared": [["connections", "decoupling"], /net ADC_X is not declared/, "C6 C 1n tol=5% volts=50 at=U1 : 1=ADC_A", "C6 C 1n tol=5% volts=50 at=U1 : 1=ADC_X"],
  "a pin that must stay free": [["connections", "drivers"], /U1\.GP15 must stay free/, "unused=VSYS,3V3_EN,RUN,ADC_VREF,GP13,GP14,GP15,GP20", "GP15=TACH unused=VSYS,3V3_EN,RUN,ADC_VREF,GP13,GP14,GP20"],
  "a pin used that the module needs itself": [["connections"], /U1\.ADC_VREF must stay free/, "unused=VSYS,3V3_EN,RUN,ADC_VREF,", "ADC_VREF=AVDD unused=VSYS,3V3_EN,RUN,"],
  "a net that stands twice": [["connections"], /net IS stands twice/, "", "", "\nnet IS 0..1V\n"],
  "a net without a range of voltage": [["connections"], /net IVM_P has no range of voltage/, "signals 10.8..13.2V: IVM_P", "signals some: IVM_P"],
  "two drivers on a net": [["drivers", "connections", "converterRange"], /net IA is driven by U2\.OUT and U3\.OUT/, "OUT=IB ", "OUT=IA "],
  "an output against an open drain": [["drivers"], /net IA is driven by U2\.OUT against M1\.FLT/, "FLT=FLT_A CS", "FLT=IA CS"],
  "an input that nobody drives": [["connections", "drivers"], /nothing drives U7\.CLK/, "GP18=SPI_CLK", "GP18=SPI_IN2"],
  "an open drain without a pull-up": [["drivers"], /open drain of M1\.FLT without a pull-up/, "1=FLT_A 2=3V3", "1=FLT_A 2=GND"],
  "a ground that is none": [["voltages"], /U8\.GND is not on GND/, "U8 LVC1G07 : VCC=3V3 GND=GND", "U8 LVC1G07 : VCC=3V3 GND=TACH"],
  "5 V on a pin for 3.3 V": [["voltages"], /U1\.GP11 stands 3\.6 V, net TACH has up to 5\.3 V/, "FAN_CTL TACH SWITCH", "FAN_CTL SWITCH\nsignals 0..5.3V: TACH"],
  "a supply below what a part needs": [["voltages"], /M1\.VIN needs 6\.5 V, net VM has down to 5 V/, "net VM 10.8..13.2V", "net VM 5..13.2V"],
  "a capacitor with too low a voltage": [["voltages", "sleepingBridges"], /C1 stands 16 V at 13\.2 V/, "C1 C 1000u tol=20% volts=35", "C1 C 1000u tol=20% volts=16"],
  "an amplifier without its capacitor": [["decoupling"], /U2\.VS has 0 nF beside it, needs 100 nF/, "C16 C 100n tol=10% volts=16 at=U2", "C16 C 100n tol=10% volts=16 at=U3"],
  "a converter's input without its capacitor": [["decoupling"], /U7\.CH0 has 0 nF beside it/, "at=U7 : 1=IA_F", "at=U2 : 1=IA_F"],
  "SLP without its pull-down": [["connections", "safeLevels"], /SLP: up to .* V \(reset\), low is 0\.8 V/, "at=U1 : 1=SLP", "at=U1 : 1=SLP2"],
  "a pull-down that loses against the drivers": [["safeLevels"], /SLP: up to 1\.\d+ V \(unpowered\)/, "R6 R 470", "R6 R 1.2k"],
  "a line that nothing holds": [["safeLevels"], /SPI_CLK: nothing holds it low \(unpowered\)/, "", "", "\nsafe SPI_CLK low unpowered\n"],
  "a switch that is on by itself": [["safeLevels"], /SWITCH: up to .* V \(reset\)/, "1=SWITCH 2=GND", "1=SWITCH 2=3V3"],
  "a fan that stands while nobody drives": [["safeLevels"], /FAN_CTL: down to .* V \(reset\)/, "R23 R 4.7k", "R23 R 47k"],
  "a bridge's input without a safe level": [["safeLinesNamed"], /M2\.PWM: no safe level is named for PWM_B/, "safe PWM_B low reset unpowered", ""],
  "a wire past the fuse": [["onlyWay"], /current reaches VM without F1/, "Q1 BTS50010 : VS=12V ", "Q1 BTS50010 : VS=12V_IN "],
  "a wire past the switch": [["onlyWay", "connections"], /current reaches VM without Q1/, "1=VM_SW 2=VM S1", "1=12V 2=VM S1"],
  "a bridge before the switch": [["onlyWay", "decoupling"], /M3 is not supplied from VM/, "M3 G2_18V17 : VIN=VM", "M3 G2_18V17 : VIN=12V"],
  "more current than a reference gives": [["currents", "converterRange"], /U6\.OUT gives 25 mA, AVDD draws 4\d\./, "R21 R 10k", "R21 R 100"],
  "more current than a pin gives": [["currents"], /U1\.GP6 gives 12 mA, SLP takes 15\.5 mA/, "R6 R 470", "R6 R 220"],
  "a pin whose drive is too weak": [["currents"], /U1\.GP6 gives 4 mA, SLP takes 7\.2 mA/, "drive U1.GP6 12mA", ""],
  "a drive that no pin has": [["currents"], /U1\.GP6 has no drive of 16 mA/, "drive U1.GP6 12mA", "drive U1.GP6 16mA"],
  "more current than all pins of the microcontroller give": [["currents"], /U1: 71 mA of all its pins, 50 mA allowed/, "R 10k tol=1% power=0.25 at=U1", "R 330 tol=1% power=0.25 at=U1"],
  "more current from USB than its descriptor asks for": [["usbPower"], /VBUS draws 113\.8 mA, the descriptor asks for 100 mA/, "usb 150mA", "usb 100mA"],
  "more current than a port gives": [["usbPower"], /the descriptor asks for 600 mA/, "usb 150mA", "usb 600mA"],
  "a fuse that blows at work": [["powerPath"], /F1 blows at 16 A, VM carries 15 A/, "F1 FUSE 20", "F1 FUSE 16"],
  "a connector that is too weak for the fuse": [["powerPath"], /J1\.\+ carries 30 A, 12V_IN has 40 A/, "F1 FUSE 20", "F1 FUSE 40"],
  "a shunt that gets too hot": [["powerPath", "converterRange"], /RS1: 1\.36 W of 1 W/, "RS1 SHUNT 1m", "RS1 SHUNT 5m"],
  "a resistor that gets too hot": [["resistorPower", "converterRange"], /R3: up to 0\.174 W, more than half of 0\.25 W/, "R3 R 47k", "R3 R 1.0k"],
  "a shunt that drives the amplifier beyond its range": [["converterRange"], /current_a: 20 A gives 3\.6\d\d V/, "RS1 SHUNT 1m", "RS1 SHUNT 2m"],
  "a divider that drives the converter beyond its range": [["converterRange"], /supply_v: 30 V gives 5\.\d+ V/, "R4 R 4.7k", "R4 R 10k"],
  "a pull-up with which a hot thermistor looks shorted": [["converterRange"], /ntc_a: 125 C gives 0\.0\d+ V/, "R21 R 10k tol", "R21 R 100k tol"],
  "something measured that has no circuit": [["converterRange"], /extra: no amplifier, divider, thermistor or driver in front of U1\.GP13/, "", "", "\nmeasure extra U1.GP13 0..1A\n"],
  "too little capacitance for bridges that fall asleep": [["decoupling", "sleepingBridges"], /all windings where the drivers chop: VM rises to \d+\.\d V, 24 V allowed/, "C 1000u", "C 220u"],
  "a fan that sleeping bridges lift": [["sleepingBridges"], /16\.5 A in one winding: J6\.12V stands 13\.2 V, 12V rises to 17\.1 V/, "12V=FAN_12V TACH", "12V=12V TACH", "\nR99 R 10k tol=1% power=0.25 : 1=FAN_12V 2=GND\n"],
  "a resettable fuse that sleeping bridges lift": [["sleepingBridges"], /16\.5 A in one winding: F2\.1 stands 16 V, 12V rises to 17\.1 V/, "POLYFUSE 1.1 volts=72", "POLYFUSE 1.1 volts=16"],
  "a capacitor before the switch that they lift": [["sleepingBridges"], /C4\.1 stands 18 V, 12V rises to 23\.5 V/, "C4 C 100n tol=10% volts=50", "C4 C 100n tol=10% volts=18"],
  "a clamp that is too small": [["sleepingBridges"], /the clamp takes 0\.10 J of 0\.05 J/, "D1 TVS :", "D1 TVS energy_j=0.05 :"],
  "no clamp": [["sleepingBridges"], /all windings where the drivers chop: VM rises to 24\.\d V/, 'D1 TVS : K=VM A=GND "what the capacitors do not take of sleeping windings"', ""],
};

for (const [what, [names, like, cut, put, more, board]] of Object.entries(kBroken))
  test(`found: ${what}`, () => breaks(names, like, cut, put, more, board));

test("each rule has a netlist above that breaks it", () => {
  const broken = new Set(Object.values(kBroken).flatMap(([names]) => names));
  assert.deepEqual(kRules.map(({ name }) => name).filter((name) => !broken.has(name)), []);
});

test("SLP in reset is far below the drivers' threshold, at what the drivers can pull at worst", () => {
  const { low, high } = restingLevel(asBuilt("reference"), kTypes, "SLP", "reset");
  // 470 ohm against three times 10 kohm to 5 V: 0.62 V; the driver's threshold is 0.8 V.
  assert.ok(high > 0.55 && high < 0.65, `${high}`);
  assert.ok(low >= 0 && low <= high);
});

// SPDX-License-Identifier: MIT
using System;

namespace Hedgehog
{
    /// <summary>A game's 0..1 as an effect that is renewed every frame.</summary>
    public static class Rumble
    {
        /// <summary>It ends so long after the last frame: a game that hangs lets go of the ball.</summary>
        public const double LeaseMs = 250;

        /// <summary>`strength` 0..1 as a level: 0 stays 0, anything above begins where a push can be felt.</summary>
        public static double FeltLevel(double strength, double feltA, double currentA)
        {
            if (!(strength > 0.0) || !(currentA > 0.0)) return 0.0;
            double felt = Math.Min(1.0, feltA / currentA);
            return felt + (1.0 - felt) * Math.Min(1.0, strength);
        }

        internal static Params Of(string slot, double strength, Results.HelloLimits limits, Direction direction, Params others)
        {
            return new Params().Set("slot", slot).Set("direction", direction).Set("lease_ms", LeaseMs).Merge(others)
                .Set("level", FeltLevel(strength, limits.FeltA, limits.CurrentA));
        }
    }
}

// SPDX-License-Identifier: MIT
using System;
using System.Diagnostics;

namespace Hedgehog
{
    /// <summary>One time limit for several attempts that follow each other. Any thread.</summary>
    internal sealed class Deadline
    {
        private readonly Func<double> nowS;
        private readonly double untilS;

        /// <summary>nowS: seconds of any clock.</summary>
        public Deadline(Func<double> nowS, int timeoutMs)
        {
            this.nowS = nowS;
            untilS = nowS() + 0.001 * timeoutMs;
        }

        /// <summary>From now on.</summary>
        public static Deadline After(int timeoutMs)
        {
            Stopwatch clock = Stopwatch.StartNew();
            return new Deadline(() => clock.Elapsed.TotalSeconds, timeoutMs);
        }

        /// <summary>The time for one of so many attempts that are left: one that nobody answers leaves some to the next. At least
        /// 1 ms, because 0 is no time limit for a socket.</summary>
        public int ShareMs(int attempts = 1)
        {
            return (int)Math.Max(1.0, 1000.0 * (untilS - nowS()) / attempts);
        }
    }
}

// SPDX-License-Identifier: MIT
using System;

namespace Hedgehog
{
    /// <summary>How long to wait before the next attempt to connect: 0.1, 0.2, 0.4 ... 5 s. Times in seconds of any clock.</summary>
    internal sealed class Backoff
    {
        private const double FirstS = 0.1;
        private const double MaxS = 5.0;

        private double waitS;
        private double nextS;

        public double RemainingS(double nowS)
        {
            return Math.Max(0.0, nextS - nowS);
        }

        /// <summary>atLeastS: the daemon wants no connection earlier.</summary>
        public void Failed(double nowS, double atLeastS)
        {
            waitS = waitS > 0.0 ? Math.Min(MaxS, 2.0 * waitS) : FirstS;
            nextS = nowS + Math.Max(waitS, atLeastS);
        }

        public void Succeeded()
        {
            waitS = 0.0;
            nextS = 0.0;
        }
    }
}

// SPDX-License-Identifier: MIT
using System;

namespace Hedgehog.Samples
{
    /// <summary>What is felt in a racing game, as clients/racer/feel has it. Directions in the ball's frame; one thread.</summary>
    public sealed class RacerHaptics
    {
        /// Eight steps from what is just felt to full strength are 32 % apart; people notice 13 % (thesis, experiment 2).
        private const int Steps = 8;
        /// Blows of these impulses are the first and the last step; Newton seconds.
        private const double SoftestBlow = 150.0;
        private const double HardestBlow = 8000.0;
        /// One blow in 0.25 s, unless a harder one comes.
        private const double ApartS = 0.25;
        /// What is sent every frame ends this long after the last.
        private const double LeaseMs = 150;
        /// A blow is felt alone; the ground going round wins over the skid.
        private const long BlowPriority = 7;
        private const long TumblePriority = 6;
        private const long SkidPriority = 5;
        /// What lasts is weaker than a blow can be: shares of full strength.
        private const double TumbleShare = 0.4;
        private const double MaxSkidShare = 0.5;
        /// The game's own gain by what the ball can still take; seconds of full strength, and parts a second.
        private const double MinGain = 0.4;
        private const double NothingInHand = 0.7;
        private const double EnoughS = 3.0;
        private const double DownPerS = 0.6;
        private const double UpPerS = 0.02;

        private int lastStep = -1;
        private double lastBlowS;
        private long lastTimeNs;

        /// <summary>How strong the game plays: 1 as strong as it may.</summary>
        public double Gain { get; private set; }

        public RacerHaptics()
        {
            Gain = 1.0;
        }

        /// <summary>The car was hit on that side. False: too soon after a harder blow, or no daemon.</summary>
        public bool Hit(AsyncBall ball, Direction side, double impulseNs, double timeS)
        {
            return Blow(ball, side, impulseNs, 180, timeS);
        }

        /// <summary>The wheels are back on the ground: from below.</summary>
        public bool Land(AsyncBall ball, double impulseNs, double timeS)
        {
            return Blow(ball, Direction.Down, impulseNs, 140, timeS);
        }

        /// <summary>Every frame while the wheels slide; amount 0 grips .. 1 no grip at all.</summary>
        public bool Skid(AsyncBall ball, double amount)
        {
            Results.HelloLimits limits = LimitsOf(ball);
            if (limits == null) return false;
            double mostA = Math.Max(limits.FeltA, MaxSkidShare * FullA(limits));
            return ball.Notify("effect.vibrate", new Params().Set("slot", "skid").Set("direction", Direction.Down)
                .Set("waveform", "square").Set("frequency_hz", 60.0).Set("lease_ms", LeaseMs).Set("priority", SkidPriority)
                .Set("current_a", Math.Min(limits.CurrentA, limits.FeltA + amount * (mostA - limits.FeltA))));
        }

        /// <summary>Every frame while the car turns over; `ground`: where it is, seen from the car.</summary>
        public bool Tumble(AsyncBall ball, Direction ground)
        {
            Results.HelloLimits limits = LimitsOf(ball);
            if (limits == null) return false;
            return ball.Notify("effect.hold", new Params().Set("slot", "tumble").Set("direction", ground)
                .Set("lease_ms", LeaseMs).Set("priority", TumblePriority)
                .Set("current_a", Math.Min(limits.CurrentA, Math.Max(limits.FeltA, TumbleShare * FullA(limits)))));
        }

        /// <summary>Telemetry with time_ns, derating and burst_s: softer while full strength could not last.</summary>
        public void Take(Results.Telemetry status)
        {
            long timeNs = status.TimeNs;
            double passedS = lastTimeNs == 0 ? 0.0 : Math.Max(0.0, Math.Min(1.0, 1e-9 * (timeNs - lastTimeNs)));
            lastTimeNs = timeNs;
            double inHand = status.BurstS.HasValue ? Math.Max(0.0, Math.Min(1.0, status.BurstS.Value / EnoughS)) : 1.0;
            double goal = status.Derating == true ? MinGain : NothingInHand + (1.0 - NothingInHand) * inHand;
            Gain = goal < Gain ? Math.Max(goal, Gain - DownPerS * passedS) : Math.Min(goal, Gain + UpPerS * passedS);
        }

        /// <summary>0..7, in equal ratios of the impulse.</summary>
        public static int StepOf(double impulseNs)
        {
            double share = Math.Log(Math.Max(impulseNs, SoftestBlow) / SoftestBlow) / Math.Log(HardestBlow / SoftestBlow);
            return (int)Math.Round((Steps - 1) * Math.Min(share, 1.0), MidpointRounding.AwayFromZero);
        }

        /// <summary>In ampere, from `feltA` to `fullA`.</summary>
        public static double StrengthOf(int step, double feltA, double fullA)
        {
            double lastA = Math.Max(feltA, fullA);
            return feltA * Math.Pow(lastA / feltA, (double)step / (Steps - 1));
        }

        private bool Blow(AsyncBall ball, Direction side, double impulseNs, double durationMs, double timeS)
        {
            int step = StepOf(impulseNs);
            bool soon = lastStep >= 0 && timeS >= lastBlowS && timeS - lastBlowS < ApartS;
            if (soon && step <= lastStep) return false;
            lastStep = step;
            lastBlowS = timeS;
            Results.HelloLimits limits = LimitsOf(ball);
            if (limits == null) return false;
            return ball.Notify("effect.pulse", new Params().Set("direction", side).Set("duration_ms", durationMs)
                .Set("priority", BlowPriority)
                .Set("current_a", Math.Min(limits.CurrentA, StrengthOf(step, limits.FeltA, FullA(limits)))));
        }

        private double FullA(Results.HelloLimits limits)
        {
            return limits.CurrentA * Gain;
        }

        private static Results.HelloLimits LimitsOf(AsyncBall ball)
        {
            Results.Hello hello = ball == null ? null : ball.Hello;
            return hello == null ? null : hello.Limits;
        }
    }
}

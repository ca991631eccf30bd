// SPDX-License-Identifier: MIT
using System.Collections.Generic;

namespace Hedgehog
{
    /// <summary>Where the pins push out: "left", a vector (x front, y left, z up), angles, or a pin.</summary>
    public sealed class Direction
    {
        public static readonly Direction Up = new Direction(Hedgehog.Json.Of("up"));
        public static readonly Direction Down = new Direction(Hedgehog.Json.Of("down"));
        public static readonly Direction Left = new Direction(Hedgehog.Json.Of("left"));
        public static readonly Direction Right = new Direction(Hedgehog.Json.Of("right"));
        public static readonly Direction Front = new Direction(Hedgehog.Json.Of("front"));
        public static readonly Direction Back = new Direction(Hedgehog.Json.Of("back"));

        private readonly Json json;

        private Direction(Json json)
        {
            this.json = json;
        }

        /// <summary>Of any length but 0. Throws ArgumentException for what is no number.</summary>
        public static Direction Vector(double x, double y, double z)
        {
            return new Direction(Hedgehog.Json.List(Hedgehog.Json.Of(x), Hedgehog.Json.Of(y), Hedgehog.Json.Of(z)));
        }

        /// <summary>Azimuth anticlockwise from the front, seen from above; elevation upwards.</summary>
        public static Direction Angles(double azimuthDeg, double elevationDeg = 0.0)
        {
            return new Direction(Hedgehog.Json.Object(new[]
            {
                new KeyValuePair<string, Json>("azimuth_deg", Hedgehog.Json.Of(azimuthDeg)),
                new KeyValuePair<string, Json>("elevation_deg", Hedgehog.Json.Of(elevationDeg))
            }));
        }

        public static Direction Pin(int number)
        {
            return new Direction(Hedgehog.Json.Object(new[]
            {
                new KeyValuePair<string, Json>("pin", Hedgehog.Json.Of((long)number))
            }));
        }

        /// <summary>"up", "down", "left", "right", "front" or "back"; the daemon refuses any other.</summary>
        public static implicit operator Direction(string word)
        {
            return word == null ? null : new Direction(Hedgehog.Json.Of(word));
        }

        internal Json Json
        {
            get { return json; }
        }
    }
}

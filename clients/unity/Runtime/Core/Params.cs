// SPDX-License-Identifier: MIT
using System.Collections.Generic;

namespace Hedgehog
{
    /// <summary>Parameters by name, as protocol/README.md has them. null is not sent.</summary>
    public sealed class Params
    {
        private readonly List<KeyValuePair<string, Json>> members = new List<KeyValuePair<string, Json>>();

        public Params Set(string name, Json value)
        {
            if (value == null || value.IsNull) return this;
            members.RemoveAll(member => member.Key == name);
            members.Add(new KeyValuePair<string, Json>(name, value));
            return this;
        }

        public Params Set(string name, double? value)
        {
            return value.HasValue ? Set(name, Json.Of(value.Value)) : this;
        }

        public Params Set(string name, long? value)
        {
            return value.HasValue ? Set(name, Json.Of(value.Value)) : this;
        }

        public Params Set(string name, bool? value)
        {
            return value.HasValue ? Set(name, Json.Of(value.Value)) : this;
        }

        public Params Set(string name, string value)
        {
            return value == null ? this : Set(name, Json.Of(value));
        }

        public Params Set(string name, Direction value)
        {
            return value == null ? this : Set(name, value.Json);
        }

        public Params Set(string name, Params value)
        {
            return value == null ? this : Set(name, value.Json);
        }

        public Params Set(string name, string[] values)
        {
            if (values == null) return this;
            var items = new Json[values.Length];
            for (int i = 0; i < values.Length; ++i) items[i] = Json.Of(values[i]);
            return Set(name, Json.List(items));
        }

        /// <summary>A list of objects, such as key frames.</summary>
        public Params Set(string name, Params[] values)
        {
            if (values == null) return this;
            var items = new Json[values.Length];
            for (int i = 0; i < values.Length; ++i) items[i] = values[i].Json;
            return Set(name, Json.List(items));
        }

        /// <summary>All of `others` on top of these.</summary>
        public Params Merge(Params others)
        {
            if (others == null) return this;
            foreach (var member in others.members) Set(member.Key, member.Value);
            return this;
        }

        internal int Count
        {
            get { return members.Count; }
        }

        internal Json Json
        {
            get { return Hedgehog.Json.Object(members); }
        }
    }
}

// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace Hedgehog
{
    public enum JsonKind
    {
        Null,
        Flag,
        Number,
        Text,
        List,
        Object
    }

    /// <summary>A JSON value that does not change. What is not there is null: status["fan"]["duty"] never throws.</summary>
    public sealed class Json
    {
        // Before the values that have them.
        private static readonly string[] NoNames = new string[0];
        private static readonly Json[] NoItems = new Json[0];

        public static readonly Json Null = new Json(JsonKind.Null);
        public static readonly Json True = new Json(JsonKind.Flag) { flag = true };
        public static readonly Json False = new Json(JsonKind.Flag);

        private readonly JsonKind kind;
        private bool flag;
        private double number;
        private long integer;
        private bool isInteger;
        private string text;
        private Json[] items = NoItems;
        private string[] names = NoNames;

        private Json(JsonKind kind)
        {
            this.kind = kind;
        }

        /// <summary>Throws ArgumentException: JSON has no infinity and no NaN.</summary>
        public static Json Of(double value)
        {
            if (double.IsNaN(value) || double.IsInfinity(value))
                throw new ArgumentException("a number that JSON does not have: " + value.ToString(CultureInfo.InvariantCulture));
            var json = new Json(JsonKind.Number) { number = value };
            // What a double holds exactly.
            if (Math.Abs(value) <= 9007199254740992.0 && Math.Floor(value) == value)
            {
                json.integer = (long)value;
                json.isInteger = true;
            }
            return json;
        }

        public static Json Of(long value)
        {
            return new Json(JsonKind.Number) { number = value, integer = value, isInteger = true };
        }

        public static Json Of(bool value)
        {
            return value ? True : False;
        }

        public static Json Of(string value)
        {
            return value == null ? Null : new Json(JsonKind.Text) { text = value };
        }

        public static Json List(params Json[] values)
        {
            return new Json(JsonKind.List) { items = (Json[])values.Clone() };
        }

        /// <summary>Of a name that comes twice the last counts.</summary>
        public static Json Object(IList<KeyValuePair<string, Json>> members)
        {
            var json = new Json(JsonKind.Object) { names = new string[members.Count], items = new Json[members.Count] };
            for (int i = 0; i < members.Count; ++i)
            {
                json.names[i] = members[i].Key;
                json.items[i] = members[i].Value ?? Null;
            }
            return json;
        }

        /// <summary>Throws FormatException with the place of what is wrong.</summary>
        public static Json Parse(string text)
        {
            return new JsonReader(text).Read();
        }

        public JsonKind Kind
        {
            get { return kind; }
        }

        public bool IsNull
        {
            get { return kind == JsonKind.Null; }
        }

        /// <summary>0 of what is no number.</summary>
        public double Number
        {
            get { return number; }
        }

        /// <summary>A number without its fraction; 0 of what is none, or too large.</summary>
        public long Integer
        {
            get
            {
                if (isInteger) return integer;
                return kind == JsonKind.Number && Math.Abs(number) < 9.2e18 ? (long)number : 0;
            }
        }

        public bool Flag
        {
            get { return flag; }
        }

        /// <summary>null of what is no string.</summary>
        public string Text
        {
            get { return text; }
        }

        /// <summary>Of a list or an object.</summary>
        public int Count
        {
            get { return items.Length; }
        }

        public Json this[int index]
        {
            get { return index >= 0 && index < items.Length ? items[index] : Null; }
        }

        public Json this[string name]
        {
            get
            {
                for (int i = names.Length - 1; i >= 0; --i)
                    if (string.Equals(names[i], name, StringComparison.Ordinal)) return items[i];
                return Null;
            }
        }

        /// <summary>Of an object, in its order.</summary>
        public string NameAt(int index)
        {
            return index >= 0 && index < names.Length ? names[index] : null;
        }

        public bool Has(string name)
        {
            return Array.IndexOf(names, name) >= 0;
        }

        public override string ToString()
        {
            var written = new StringBuilder();
            Write(written);
            return written.ToString();
        }

        internal static Json Exact(double value, bool isInteger, long integer)
        {
            return new Json(JsonKind.Number) { number = value, isInteger = isInteger, integer = integer };
        }

        internal void Write(StringBuilder to)
        {
            switch (kind)
            {
                case JsonKind.Null:
                    to.Append("null");
                    break;
                case JsonKind.Flag:
                    to.Append(flag ? "true" : "false");
                    break;
                case JsonKind.Number:
                    if (isInteger) to.Append(integer.ToString(CultureInfo.InvariantCulture));
                    else to.Append(number.ToString("R", CultureInfo.InvariantCulture));
                    break;
                case JsonKind.Text:
                    WriteText(text, to);
                    break;
                default:
                    WriteItems(to);
                    break;
            }
        }

        private void WriteItems(StringBuilder to)
        {
            to.Append(kind == JsonKind.List ? '[' : '{');
            for (int i = 0; i < items.Length; ++i)
            {
                if (i > 0) to.Append(',');
                if (kind == JsonKind.Object)
                {
                    WriteText(names[i], to);
                    to.Append(':');
                }
                items[i].Write(to);
            }
            to.Append(kind == JsonKind.List ? ']' : '}');
        }

        private static void WriteText(string text, StringBuilder to)
        {
            to.Append('"');
            for (int i = 0; i < text.Length; ++i)
            {
                char c = text[i];
                if (c == '"' || c == '\\') to.Append('\\').Append(c);
                else if (c < ' ' || IsHalf(text, i)) to.Append("\\u").Append(((int)c).ToString("x4", CultureInfo.InvariantCulture));
                else to.Append(c);
            }
            to.Append('"');
        }

        /// Half of a pair of surrogates, which UTF-8 cannot carry.
        private static bool IsHalf(string text, int at)
        {
            if (char.IsHighSurrogate(text[at])) return at + 1 >= text.Length || !char.IsLowSurrogate(text[at + 1]);
            return char.IsLowSurrogate(text[at]) && (at == 0 || !char.IsHighSurrogate(text[at - 1]));
        }
    }
}

// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace Hedgehog
{
    /// <summary>JSON text to a value, as RFC 8259 has it: nothing more is taken. Every error is a FormatException.</summary>
    internal sealed class JsonReader
    {
        /// Deeper nesting is refused, so that no text exhausts the stack.
        private const int MaxDepth = 64;

        private readonly string text;
        private int at;

        public JsonReader(string text)
        {
            this.text = text;
        }

        public Json Read()
        {
            Json value = Value(0);
            SkipBlanks();
            if (at < text.Length) throw Wrong("something follows the value");
            return value;
        }

        private Json Value(int depth)
        {
            if (depth > MaxDepth) throw Wrong("nested too deeply");
            SkipBlanks();
            switch (Peek())
            {
                case '{': return Object(depth);
                case '[': return List(depth);
                case '"': return Json.Of(Text());
                case 't': return Word("true", Json.True);
                case 'f': return Word("false", Json.False);
                case 'n': return Word("null", Json.Null);
                default: return Number();
            }
        }

        private Json Object(int depth)
        {
            var members = new List<KeyValuePair<string, Json>>();
            ++at;
            SkipBlanks();
            if (Take('}')) return Json.Object(members);
            do
            {
                SkipBlanks();
                if (Peek() != '"') throw Wrong("a name is missing");
                string name = Text();
                SkipBlanks();
                if (!Take(':')) throw Wrong("':' is missing");
                members.Add(new KeyValuePair<string, Json>(name, Value(depth + 1)));
                SkipBlanks();
            } while (Take(','));
            if (!Take('}')) throw Wrong("'}' is missing");
            return Json.Object(members);
        }

        private Json List(int depth)
        {
            var items = new List<Json>();
            ++at;
            SkipBlanks();
            if (Take(']')) return Json.List();
            do
            {
                items.Add(Value(depth + 1));
                SkipBlanks();
            } while (Take(','));
            if (!Take(']')) throw Wrong("']' is missing");
            return Json.List(items.ToArray());
        }

        private string Text()
        {
            var read = new StringBuilder();
            ++at;
            for (;;)
            {
                if (at >= text.Length) throw Wrong("a string does not end");
                char c = text[at++];
                if (c == '"') return read.ToString();
                if (c < ' ') throw Wrong("a control character in a string");
                read.Append(c == '\\' ? Escaped() : c);
            }
        }

        private char Escaped()
        {
            char c = at < text.Length ? text[at++] : '\0';
            switch (c)
            {
                case '"':
                case '\\':
                case '/': return c;
                case 'b': return '\b';
                case 'f': return '\f';
                case 'n': return '\n';
                case 'r': return '\r';
                case 't': return '\t';
                case 'u': return Unit();
                default: throw Wrong("no such escape");
            }
        }

        private char Unit()
        {
            int unit = 0;
            for (int i = 0; i < 4; ++i)
            {
                int digit = at < text.Length ? HexDigit(text[at]) : -1;
                if (digit < 0) throw Wrong("\\u needs four hexadecimal digits");
                unit = 16 * unit + digit;
                ++at;
            }
            return (char)unit;
        }

        private static int HexDigit(char c)
        {
            if (c >= '0' && c <= '9') return c - '0';
            if (c >= 'a' && c <= 'f') return c - 'a' + 10;
            return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
        }

        private Json Number()
        {
            int start = at;
            Take('-');
            int whole = Digits();
            if (whole == 0) throw Wrong("no value");
            if (whole > 1 && text[at - whole] == '0') throw Wrong("a number begins with 0");
            bool isInteger = true;
            if (Take('.'))
            {
                isInteger = false;
                if (Digits() == 0) throw Wrong("no digit after the point");
            }
            if (Take('e') || Take('E'))
            {
                isInteger = false;
                if (!Take('+')) Take('-');
                if (Digits() == 0) throw Wrong("no digit in the exponent");
            }
            string digits = text.Substring(start, at - start);
            double value;
            // Some runtimes refuse what is too large, others make it infinite.
            if (!double.TryParse(digits, NumberStyles.Float, CultureInfo.InvariantCulture, out value) || double.IsInfinity(value))
                throw Wrong("a number that is too large");
            long integer = 0;
            if (isInteger) isInteger = long.TryParse(digits, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out integer);
            return isInteger ? Json.Exact(value, true, integer) : Json.Of(value);
        }

        private int Digits()
        {
            int start = at;
            while (at < text.Length && text[at] >= '0' && text[at] <= '9') ++at;
            return at - start;
        }

        private Json Word(string word, Json value)
        {
            if (string.CompareOrdinal(text, at, word, 0, word.Length) != 0) throw Wrong("no value");
            at += word.Length;
            return value;
        }

        private void SkipBlanks()
        {
            while (at < text.Length && (text[at] == ' ' || text[at] == '\t' || text[at] == '\n' || text[at] == '\r')) ++at;
        }

        private char Peek()
        {
            return at < text.Length ? text[at] : '\0';
        }

        private bool Take(char wanted)
        {
            if (at >= text.Length || text[at] != wanted) return false;
            ++at;
            return true;
        }

        private FormatException Wrong(string why)
        {
            return new FormatException(why + ", at character " + at.ToString(CultureInfo.InvariantCulture));
        }
    }
}

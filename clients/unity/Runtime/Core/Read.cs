// SPDX-License-Identifier: MIT
using System;

namespace Hedgehog.Results
{
    /// <summary>Lists of a result.</summary>
    internal static class Read
    {
        public static double[] Numbers(Json list)
        {
            var numbers = new double[list.Count];
            for (int i = 0; i < numbers.Length; ++i) numbers[i] = list[i].Number;
            return numbers;
        }

        public static string[] Texts(Json list)
        {
            var texts = new string[list.Count];
            for (int i = 0; i < texts.Length; ++i) texts[i] = list[i].Text;
            return texts;
        }

        public static T[] List<T>(Json list, Func<Json, T> of) where T : class
        {
            var items = new T[list.Count];
            for (int i = 0; i < items.Length; ++i) items[i] = of(list[i]);
            return items;
        }
    }
}

// SPDX-License-Identifier: MIT
using Hedgehog.Unity;
using UnityEngine;

namespace Hedgehog.Samples
{
    /// <summary>Beside the Rigidbody of a car: what happens to it is felt. Skid and tumble are the car's own to tell, each
    /// frame while they last.</summary>
    public sealed class RacerCar : MonoBehaviour
    {
        [SerializeField]
        private HedgehogBall ball = null;

        /// How often the gain follows what the ball can still take.
        private const float StatusHz = 5f;
        private readonly RacerHaptics haptics = new RacerHaptics();

        /// <summary>0 grips .. 1 no grip at all.</summary>
        public void Skid(float amount)
        {
            haptics.Skid(ball.Client, amount);
        }

        /// <summary>The car lies on its side or roof.</summary>
        public void Tumble()
        {
            haptics.Tumble(ball.Client, HedgehogBall.ToBall(transform.InverseTransformDirection(Vector3.down)));
        }

        public void Land(float impulseNs)
        {
            haptics.Land(ball.Client, impulseNs, Time.time);
        }

        private void OnEnable()
        {
            ball.TelemetryReceived += haptics.Take;
            ball.SubscribeTelemetry(StatusHz, "derating", "burst_s");
        }

        private void OnDisable()
        {
            ball.TelemetryReceived -= haptics.Take;
        }

        private void OnCollisionEnter(Collision hit)
        {
            Vector3 side = transform.InverseTransformPoint(hit.GetContact(0).point);
            haptics.Hit(ball.Client, HedgehogBall.ToBall(side), hit.impulse.magnitude, Time.time);
        }
    }
}

/**
 * What the topics of a fleet are called and what their records look like: JSON, version 1, as docs/fleet.md has it. It
 * may use {@code device}, and knows nothing of Kafka.
 */
@NullMarked
package org.evoloop.fleet.wire;

import org.jspecify.annotations.NullMarked;

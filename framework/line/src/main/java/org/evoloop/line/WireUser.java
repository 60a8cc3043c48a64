package org.evoloop.line;

import java.io.IOException;

/**
 * Receives what happens on a wire.
 *
 * <p>Threading: called on the reading thread.
 */
interface WireUser {
    /** The wire is connected. */
    default void connected() throws IOException {}

    /** A line was received. */
    default void heard(String line) {}

    /** The wire is lost. */
    default void lost(String why) {}
}

package org.evoloop.payload.report;

/**
 * Sends something to a device.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface Transmission {
    /**
     * Sends it.
     *
     * @param pending is told if nothing will be reported of it
     * @throws Exception any failure: nothing was sent, unless it is an {@link
     *     org.evoloop.converter.UnknownEffectException}
     */
    void send(Pending pending) throws Exception;
}

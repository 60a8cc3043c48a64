package org.evoloop.fleet.wire;

/**
 * A mark in {@link Topic#DEAD_LETTERS}: the letters of a reason before an offset have been sent again.
 *
 * @param reason the word for their {@link Refusal.Reason}
 * @param before the offset of the first letter that the mark does not include
 * @since 0.1
 */
public record Resent(String reason, long before) {
    /** The record. */
    public byte[] bytes() {
        return Wire.record(Wire.SCHEMA)
                .put("resent", reason)
                .put("before", before)
                .toBytes();
    }
}

package org.evoloop.fleet.wire;

import java.util.Base64;
import org.evoloop.payload.JsonRecord;

/**
 * A record of {@link Topic#DEAD_LETTERS}: one that could not be processed, and why.
 *
 * @param reason the word for a {@link Refusal.Reason}, such as {@code unknown-device}
 * @param detail the problem, for people
 * @param topic the name of the topic that the record came from
 * @param record the record, or only its beginning
 * @param isWhole whether it is the whole record
 * @since 0.1
 */
@SuppressWarnings("ArrayRecordComponent") // nobody compares letters
public record DeadLetter(String reason, String detail, String topic, byte[] record, boolean isWhole) {
    /** @throws Refusal if it is not a dead letter */
    static DeadLetter read(JsonRecord letter) {
        try {
            return new DeadLetter(
                    letter.text("reason"),
                    letter.text("detail"),
                    letter.text("topic"),
                    Base64.getDecoder().decode(letter.text("record")),
                    letter.number("bytes", 0) == 0);
        } catch (IllegalArgumentException e) {
            throw new Refusal(Refusal.Reason.MALFORMED, "'record' is not in Base64");
        }
    }
}

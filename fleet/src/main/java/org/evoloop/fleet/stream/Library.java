package org.evoloop.fleet.stream;

import java.util.HashMap;
import java.util.Map;
import org.apache.kafka.streams.state.ReadOnlyKeyValueStore;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Refusal;

/** The published models, compiled on first use. A version is read only once. */
final class Library {
    private final ReadOnlyKeyValueStore<String, byte[]> published;
    private final Map<String, Model> compiled = new HashMap<>();

    Library(ReadOnlyKeyValueStore<String, byte[]> published) {
        this.published = published;
    }

    /** @throws Refusal if there are no such models, or they cannot be used */
    Model model(String version) {
        Model known = compiled.get(version);
        if (known == null) {
            byte[] record = published.get(version);
            if (record == null) {
                throw new Refusal(
                        Refusal.Reason.UNKNOWN_MODEL, "there are no models " + version + "; publish them first");
            }
            known = ModelRecord.read(version, record);
            compiled.put(version, known);
        }
        return known;
    }
}

package org.evoloop.mqtt.home;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.evoloop.console.OfferedModels;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The pictures of the new models: of the one that runs, and of each that can be chosen.
 *
 * <p>Threading: not thread-safe.
 */
final class HomePictures {
    private static final Logger LOG = LoggerFactory.getLogger(HomePictures.class);

    private final Function<ModelPair, String> draw;

    /** What is offered: references by names. */
    private final Map<String, String> offered;

    private final Optional<OfferedModels> models;

    /**
     * A picture.
     *
     * @param key in topics
     * @param title for people
     */
    record Titled(String key, String title, String svg) {}

    /** @param draw as SVG; empty for what cannot be drawn */
    HomePictures(Function<ModelPair, String> draw, Optional<OfferedModels> models) {
        this.draw = draw;
        this.models = models;
        this.offered = models.map(Choice::named).filter(all -> all.size() > 1).orElse(Map.of());
    }

    /** All of them. */
    List<Titled> of(ModelPair running) {
        List<Titled> all = new ArrayList<>();
        add(all, "picture", "Picture", running);
        offered.forEach((name, reference) -> {
            try {
                add(
                        all,
                        "picture_" + HomeDiscovery.key(name),
                        "Picture of " + name,
                        models.orElseThrow().pair(reference));
            } catch (ModelException gone) {
                LOG.warn("there is no picture of {}: {}", name, gone.getMessage());
            }
        });
        return all;
    }

    private void add(List<Titled> all, String key, String title, ModelPair pair) {
        String svg = draw.apply(pair);
        if (!svg.isEmpty()) {
            all.add(new Titled(key, title, svg));
        }
    }
}

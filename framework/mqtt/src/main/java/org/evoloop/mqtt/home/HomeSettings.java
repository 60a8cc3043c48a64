package org.evoloop.mqtt.home;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The settings of a converter, and what the broker keeps of them: for each, what it was when the converter was started, and
 * what it was set to. What was set counts as long as the converter is started with the same.
 *
 * <p>Threading: {@link #begin} before the others; thread-safe.
 */
final class HomeSettings {
    private static final Logger LOG = LoggerFactory.getLogger(HomeSettings.class);

    private final List<HomeSetting> all = new ArrayList<>();
    private final Map<HomeSetting, String> usual = new LinkedHashMap<>();
    /** Whether what is set now is newer than what the broker keeps. */
    private boolean known;

    void add(HomeSetting setting) {
        all.add(setting);
    }

    List<HomeSetting> all() {
        return all;
    }

    /** What they are now is what the converter was started with. */
    void begin() {
        all.forEach(each -> usual.put(each, each.kept()));
    }

    /** What they show. */
    JsonObject shown() {
        JsonObject shown = new JsonObject();
        all.forEach(each -> shown.put(each.key(), each.shown()));
        return shown;
    }

    /**
     * Sets one.
     *
     * @return what the broker is to keep
     */
    synchronized String set(HomeSetting setting, String wanted) {
        setting.set(wanted);
        return kept();
    }

    private String kept() {
        known = true;
        JsonObject kept = new JsonObject();
        usual.forEach((setting, begun) -> {
            if (setting.isSet()) {
                kept.put(setting.key(), new JsonObject().put("usual", begun).put("now", setting.kept()));
            }
        });
        return kept.toString();
    }

    /**
     * Takes what the broker has kept; only the first time, and not after something was set.
     *
     * @return what the broker is to keep from now on; empty for what it has
     */
    synchronized String restore(String kept) {
        if (known) {
            return "";
        }
        JsonRecord record;
        try {
            record = JsonRecord.of(kept);
        } catch (IllegalArgumentException wrong) {
            LOG.warn("what the broker has kept of the settings cannot be read, and is ignored: {}", wrong.getMessage());
            return "";
        }
        usual.forEach((setting, begun) -> record.inner(setting.key())
                .filter(each -> begun.equals(each.text("usual", "")))
                .filter(each -> !setting.kept().equals(each.text("now", begun)))
                .ifPresent(each -> restore(setting, each.text("now", begun))));
        return kept();
    }

    private static void restore(HomeSetting setting, String value) {
        try {
            setting.restore(value);
            LOG.info("{} is {} again, as it was set before", setting.name(), value);
        } catch (RuntimeException refused) {
            LOG.warn("{} stays as it is: {}", setting.name(), refused.getMessage());
        }
    }
}

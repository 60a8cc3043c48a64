package org.evoloop.config;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.config.Entry.Value;
import org.evoloop.statemachine.Names;

/** Merges command line and file into settings: the command line wins. */
final class Merge {
    private final Options options;
    private final Mistakes mistakes;

    Merge(Options options, Mistakes mistakes) {
        this.options = options;
        this.mistakes = mistakes;
    }

    Map<Option<?>, Setting> merged(List<Entry> words, List<Entry> lines) {
        Map<Option<?>, Entry> given = known(words);
        Map<Option<?>, Entry> inFile = known(lines);
        for (Option<?> option : given.keySet()) {
            inFile.keySet()
                    .removeIf(other -> other == option || option.insteadOf().contains(other.name()));
        }
        given.putAll(inFile);
        given.forEach((option, entry) -> mistakes.knows(option.name(), entry.origin()));
        Map<Option<?>, Setting> settings = new LinkedHashMap<>();
        given.forEach((option, entry) -> setting(option, entry).ifPresent(setting -> settings.put(option, setting)));
        return settings;
    }

    /** The entries of known options, with repeated ones on a command line combined. */
    private Map<Option<?>, Entry> known(List<Entry> entries) {
        Map<Option<?>, Entry> known = new LinkedHashMap<>();
        for (Entry entry : entries) {
            Optional<Option<?>> found = options.find(entry.name());
            if (found.isEmpty()) {
                unknown(entry);
                continue;
            }
            Option<?> option = found.get();
            Entry before = known.putIfAbsent(option, entry);
            if (entry.origin().isFile() && Options.OWN.contains(option)) {
                mistakes.in(option.name(), entry.origin(), "--" + entry.name() + " belongs on the command line");
                known.remove(option);
            } else if (before != null && option.repeats() && !entry.origin().isFile()) {
                List<Value> values = new ArrayList<>(before.values());
                values.addAll(entry.values());
                known.put(option, new Entry(before.name(), before.origin(), true, true, values));
            } else if (before != null) {
                mistakes.in(option.name(), entry.origin(), twice(option, before, entry));
            }
        }
        return known;
    }

    private static String twice(Option<?> option, Entry before, Entry again) {
        String name = "--" + again.name();
        if (!again.origin().isFile()) {
            return name + " is given twice; keep one";
        }
        return name + " is given twice, first in line " + before.origin().line()
                + (option.repeats() ? "; make one list of both" : "; keep one");
    }

    private void unknown(Entry entry) {
        String message = "there is no option --" + Names.shown(entry.name());
        Optional<Secret> secret = options.secrets().stream()
                .filter(each -> each.name().equals(entry.name()))
                .findFirst();
        if (secret.isPresent()) {
            mistakes.at(
                    entry.origin(),
                    message + ", since others could read it; put the secret into a file, and name that with --"
                            + secret.get().file().name());
            return;
        }
        String hint = Names.hint(entry.name(), options.names());
        boolean similar = hint.startsWith("; did you mean");
        mistakes.at(entry.origin(), message + (similar ? hint : "; see " + options.program() + " --help"));
    }

    private Optional<Setting> setting(Option<?> option, Entry entry) {
        if (!entry.readable()) {
            mistakes.spoils(option.name());
            return Optional.empty();
        }
        if (entry.list() && !option.repeats()) {
            mistakes.in(option.name(), entry.origin(), "--" + option.name() + " takes one value, not a list");
            return Optional.empty();
        }
        List<String> texts = new ArrayList<>();
        List<Object> values = new ArrayList<>();
        for (Value value : entry.values()) {
            try {
                String text = placed(option, value);
                values.add(option.read(text));
                texts.add(text);
            } catch (IllegalArgumentException refused) {
                mistakes.in(option.name(), value.origin(), String.valueOf(refused.getMessage()));
            }
        }
        return mistakes.isFaulty(option.name()) || values.isEmpty()
                ? Optional.empty()
                : Optional.of(new Setting(entry.origin(), texts, values));
    }

    private static String placed(Option<?> option, Value value) {
        if (value.text().isEmpty() && !option.isFlag()) {
            throw new IllegalArgumentException(
                    "--" + option.name() + " has an empty value; write one, or leave it out");
        }
        var file = value.origin().file();
        var folder = file == null ? null : file.toAbsolutePath().getParent();
        return folder == null ? value.text() : option.placed(folder, value.text());
    }
}

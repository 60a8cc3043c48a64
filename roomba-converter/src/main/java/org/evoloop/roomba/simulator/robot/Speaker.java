package org.evoloop.roomba.simulator.robot;

import java.util.HashMap;
import java.util.Map;
import org.evoloop.roomba.oi.ActuatorCommand.Song;
import org.evoloop.roomba.simulator.body.Body;

/** Stores songs and plays one at a time. */
final class Speaker {
    private static final double DURATIONS_PER_SECOND = 64;

    private final Map<Integer, Song> songs = new HashMap<>();
    private int number;
    private double secondsLeft;

    void store(Song song) {
        songs.put(song.number(), song);
    }

    /** Plays a song from its start; one that was never stored is ignored. */
    void play(int songNumber) {
        Song song = songs.get(songNumber);
        if (song != null) {
            number = songNumber;
            secondsLeft = song.notes().stream()
                            .mapToInt(Song.Note::durationIn64thsOfSecond)
                            .sum()
                    / DURATIONS_PER_SECOND;
        }
    }

    void tick() {
        secondsLeft = Math.max(0, secondsLeft - Body.TICK_SECONDS);
    }

    /** Of the song that plays or played last. */
    int number() {
        return number;
    }

    boolean isPlaying() {
        return secondsLeft > 0;
    }
}

-- The search knows one i: dotted or not, large or small (İZNİK, ışık), as whoever writes Turkish
-- types it on any keyboard.
UPDATE sherd_text SET words = replace(replace(words, 'İ', 'i'), 'ı', 'i')
  WHERE instr(words, 'İ') OR instr(words, 'ı');
